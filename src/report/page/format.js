// Numbers as people read them: sensible digits, units, and a dash for what was not measured.

const dash = "–";
const narrowSpace = "\u202f";

const isNumber = (value) => typeof value === "number" && Number.isFinite(value);
const orDash = (value, text) => (isNumber(value) ? text(value) : dash);

const formatError = (value) => orDash(value, (v) => (v === 0 ? "0" : Math.abs(v) < 0.00005 ? "<0.0001" : v.toFixed(4)));
const formatSigned = (value) => orDash(value, (v) => (v === 0 ? "0" : (v < 0 ? "−" : "+") + Math.abs(v).toFixed(4)));
const formatPercent = (value) => orDash(value, (v) => {
  const percent = 100 * v;
  return percent === 0 ? "0" : percent < 0.005 ? "<0.01" : percent.toFixed(percent >= 99.95 ? 0 : percent >= 10 ? 1 : 2);
});
const formatShare = (value) => orDash(value, (v) => (v === 0 ? "0" : v.toFixed(2)));

// Three significant digits, never an exponent.
const formatMs = (value) => orDash(value, (v) => {
  if (v === 0) return "0";
  if (v < 0.0005) return "<0.001";
  return v >= 1000 ? Math.round(v).toLocaleString("en").replaceAll(",", narrowSpace)
    : v >= 100 ? v.toFixed(0) : v >= 10 ? v.toFixed(1) : v >= 1 ? v.toFixed(2) : v.toFixed(3);
});
const formatDb = (value) => orDash(value, (v) => v.toFixed(1));
const formatMiB = (value) => orDash(value, (v) => {
  const mib = v / 1048576;
  return mib !== 0 && mib < 0.05 ? "<0.1" : mib >= 1000 ? mib.toFixed(0) : mib.toFixed(1);
});
const formatCount = (value) => orDash(value, (v) => Math.round(v).toLocaleString("en").replaceAll(",", narrowSpace));

const withUnit = (text, unit) => (text === dash ? text : text + narrowSpace + unit);
const plural = (count, word) => `${formatCount(count)} ${word}${count === 1 ? "" : "s"}`;
