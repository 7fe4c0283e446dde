// Elements from data. Text goes in as text only: nothing in this page is ever parsed as HTML.

const byId = (id) => document.getElementById(id);

// el("td", {class: "number", onclick: f}, "text", element, [more]); null and false children are left out.
function el(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

// A <select> of options or of groups of options: [{label, value}] or [{label, options: [{label, value}]}].
function fillSelect(select, entries, value) {
  const option = (entry) => el("option", { value: entry.value }, entry.label);
  select.replaceChildren(...entries.map((entry) =>
    entry.options ? el("optgroup", { label: entry.label }, entry.options.map(option)) : option(entry)));
  select.value = value;
}

// A colour of the style sheet as it is now: the canvas follows light, dark and print.
function cssColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function cssFont(size, weight = 400) {
  return `${weight} ${size}px ${getComputedStyle(document.body).fontFamily}`;
}
