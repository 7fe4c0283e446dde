// Masthead, scene selector, choice of reference, the three figures that sum the group up.

function lightText(light) {
  const name = light.name ?? light.kind ?? "light";
  const size = isNumber(light.angular_diameter_deg) ? `, ${light.angular_diameter_deg}° across`
    : isNumber(light.radius_m) ? `, radius ${light.radius_m}${narrowSpace}m` : "";
  return light.kind && light.kind !== name ? `${name} (${light.kind}${size})` : name + size;
}

function renderFacts() {
  const { gnomon = {}, scene, camera, lights, size, samples, device = {} } = sample(state.group);
  byId("scene").textContent = scene.name;
  byId("build").textContent = [gnomon.version, gnomon.commit, gnomon.build].filter(Boolean).join(" · ");
  const driver = [device?.driver, device?.driver_version].filter(Boolean).join(", ");
  const facts = [
    ["Size", `${size[0]} × ${size[1]}`],
    ["Samples", `${samples} a pixel`],
    ["Camera", camera?.name],
    ["Light", (lights ?? []).map(lightText).join("; ")],
    ["Triangles", isNumber(scene.triangles) ? formatCount(scene.triangles) : null],
    ["Device", [device?.name, driver && `(${driver})`].filter(Boolean).join(" ")],
  ];
  byId("facts").replaceChildren(...facts.filter(([, text]) => text).map(([name, text]) =>
    el("div", {}, el("dt", {}, name), el("dd", {}, text))));
  byId("colophon").textContent = [
    `${plural(state.group.rows.length, "row")} of ${plural(groups.length, "configuration")}.`,
    "Errors are means over receivers: samples whose surface faces the light.",
    "GPU time is build + resolve, medians. This page holds all of its data and loads nothing.",
  ].join(" ");
}

function renderGroupSelect(onChange) {
  const select = byId("group");
  fillSelect(select, groups.map((group, index) => ({ label: group.title.join(" · "), value: String(index) })), "0");
  byId("group-field").hidden = groups.length === 1;
  select.addEventListener("change", () => onChange(groups[Number(select.value)]));
}

function renderKindSwitch(onChange) {
  const present = kindsOf(state.group);
  const field = byId("kind");
  field.hidden = present.length < 2;
  byId("toolbar").hidden = field.hidden && groups.length === 1;
  field.replaceChildren(el("legend", {}, "Errors against"), ...present.map((kind) =>
    el("label", {},
      el("input", { type: "radio", name: "kind", value: kind, checked: kind === state.kind, onchange: () => onChange(kind) }),
      el("span", {}, kinds[kind].label))));
}

// Another truth may have another winner: who reads only the first line must see that.
function othersText(winner) {
  const texts = kindsOf(state.group).filter((kind) => kind !== state.kind).map((kind) => {
    const best = state.group.rows.filter((row) => isNumber(row[kind]?.mae)).sort((a, b) => a[kind].mae - b[kind].mae)[0];
    return best && best !== winner ? `against ${kinds[kind].label} it is ${best.label} (${formatError(best[kind].mae)})` : null;
  }).filter(Boolean);
  return texts.length > 0 ? texts.join("; ") : null;
}

function renderSummary() {
  const rows = state.group.rows;
  const best = (value) => rows.filter((row) => isNumber(value(row))).sort((a, b) => value(a) - value(b))[0];
  const error = (row) => row[state.kind]?.mae;
  const exact = best(error), fast = best((row) => row.gpu.total);
  const points = costPoints(), front = paretoFront(points);
  const missing = rows.filter((row) => !row.available).length;
  const card = (title, name, ...more) => el("div", {}, el("dt", {}, title), el("dd", {}, name),
    more.filter(Boolean).map((text) => el("dd", { class: "more" }, text)));
  byId("summary").replaceChildren(el("dl", {},
    exact && card("Smallest error", ...labelParts(exact), `mae ${formatError(error(exact))} against ${kinds[state.kind].label}: ${kinds[state.kind].words}`,
      othersText(exact)),
    fast && card("Least GPU time", ...labelParts(fast), withUnit(formatMs(fast.gpu.total), "ms")),
    front.length > 0 && card("Best for their cost", `${front.length} of ${points.length}`, "on the Pareto front below"),
    missing > 0 && card("Unavailable", String(missing), "reasons in the table")));
}
