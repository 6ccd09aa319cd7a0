// How numbers are written.

const MINUS = "\u2212";
const signed = (text) => text.replaceAll("-", MINUS);

// A number with so many decimals that columns stand under each other, as the command line prints it.
function exact(value, decimals = 10) {
  if (Math.abs(value) >= 1e-3 || value === 0) return signed(value.toFixed(decimals));
  return signed(value.toExponential(3));
}

// A number that is known up to an error: with as many decimals, at most `decimals`, as the error leaves certain.
function settled(value, error, decimals = 10) {
  for (let digits = decimals; digits > 0; digits--) {
    const text = exact(value, digits);
    if (exact(value - error, digits) === text && exact(value + error, digits) === text) return text;
  }
  return brief(value);
}

// A number in a few digits, for axes and short texts.
function brief(value, digits = 4) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return signed(value.toExponential(Math.max(0, digits - 3)));
  return signed(String(Number(value.toPrecision(digits))));
}

// A number as one would type it: 0.3 for 0.30000000000000004, and every digit of 8.571428571428571.
function plain(value) {
  for (const digits of [6, 9, 12]) {
    const short = Number(value.toPrecision(digits));
    if (Math.abs(short - value) <= 4 * Number.EPSILON * Math.abs(value)) return String(short);
  }
  return String(value);
}

const withUnit = (label, unit) => (unit ? `${label} [${unit}]` : label);
