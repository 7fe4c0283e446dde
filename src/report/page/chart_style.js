// What both charts share: colours of the style sheet, axes, tooltips, text that fits.

function chartColours() {
  const names = ["ink", "muted", "line", "panel", "accent", ...stageNames];
  return Object.fromEntries(names.map((name) => [name, cssColour(`--${name}`)]));
}

// Ticks of an axis that starts at zero: plain figures as long as they are short, 5e-6 below.
function plainTick(value) {
  const rounded = Number(value.toPrecision(3));
  return rounded !== 0 && Math.abs(rounded) < 0.001 ? rounded.toExponential() : String(rounded);
}

function shortened(ctx, text, width) {
  if (ctx.measureText(text).width <= width) return text;
  let length = text.length;
  while (length > 1 && ctx.measureText(text.slice(0, length) + "…").width > width) --length;
  return text.slice(0, length) + "…";
}

// Grid lines only where a tick has a label: on a logarithmic axis the others run together. A bare axis has none at zero.
function chartAxis(colours, title, { isBare = false, ...more } = {}) {
  return {
    title: { display: true, text: title, color: colours.muted, font: { size: 12 } },
    grid: {
      color: (c) => (c.tick?.label === "" || (isBare && c.tick?.value === 0) ? "transparent" : colours.line),
      borderColor: colours.line,
      tickColor: "transparent",
    },
    ...more,
    ticks: { color: colours.muted, font: { size: 11 }, ...more.ticks },
  };
}

function chartTooltip(colours, callbacks, more = {}) {
  return {
    backgroundColor: colours.ink, titleColor: colours.panel, bodyColor: colours.panel,
    displayColors: false, padding: 10, cornerRadius: 6, callbacks, ...more,
  };
}

// A click on a point or a bar opens its row in the table.
const openOnClick = (rowAt) => (event, hits) => { if (hits.length) showRow(rowAt(hits[0].index)); };
