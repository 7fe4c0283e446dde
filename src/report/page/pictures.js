// The gallery: one line of thumbnails per technique, and the references that all share.

const pictureUri = (picture) => data.pictures[picture.index];

// The reference that a picture is to be held against; error maps against the technique's own shaded picture.
function counterpart(row, picture) {
  const byKey = (key) => row.pictures.find((other) => other.key === key);
  if (picture.key === "shaded") return byKey("reference_shaded");
  if (picture.key === "mask") return byKey(`reference.${state.kind}`) ?? row.references[0];
  return isReference(picture) ? byKey(picture.key === "reference_shaded" ? "shaded" : "mask") : byKey("shaded");
}

// Each picture of the group once: the references are the same files in all rows.
function groupPictures() {
  const references = [], seen = new Set();
  for (const row of state.group.rows) {
    for (const picture of row.references) {
      if (!seen.has(picture.id)) references.push({ row, picture });
      seen.add(picture.id);
    }
  }
  const own = state.group.rows.filter((row) => row.own.length > 0);
  return { references, own };
}

function thumbnail(row, picture, name) {
  const [width, height] = sample(state.group).size;
  const show = () => {
    showPair(picture, counterpart(row, picture));
    byId("compare-section").scrollIntoView({ behavior: "smooth", block: "start" });
  };
  return el("button", { type: "button", class: "thumbnail", onclick: show, title: `${name}, ${picture.label}: show above` },
    el("img", { src: pictureUri(picture), width, height, decoding: "async", alt: `${name}, ${picture.label}` }),
    el("span", {}, picture.label));
}

function renderGallery() {
  const { references, own } = groupPictures();
  const line = (title, more, thumbnails) => el("section", { class: "strip" },
    el("h3", {}, title, more.filter(Boolean).map((text) => el("small", {}, text))), el("div", { class: "thumbnails" }, thumbnails));
  const sections = [];
  if (references.length) {
    sections.push(line("Reference", ["ray traced"], references.map(({ row, picture }) => thumbnail(row, picture, "reference"))));
  }
  for (const row of own) {
    const mae = row[state.kind]?.mae, [technique, settings] = labelParts(row);
    const thumbnails = row.own.map((picture) => thumbnail(row, picture, row.label));
    sections.push(line(technique, [settings, isNumber(mae) && `mae ${formatError(mae)}`], thumbnails));
  }
  byId("gallery").replaceChildren(...sections);
  byId("gallery-section").hidden = byId("compare-section").hidden = sections.length === 0;
}
