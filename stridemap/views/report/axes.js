// What charts on a canvas are drawn of: lines, boxes, hatching, and axes with their ticks and names.

function segment(pen, x0, y0, x1, y1) {
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
}

function fillBox(pen, { x, y, width, height }, colour, more) {
  pen.fillStyle = colour;
  pen.fillRect(x - more, y - more, width + 2 * more, height + 2 * more);
}

function strokeCross(pen, { x, y, width, height }) {
  pen.strokeStyle = styled("ink-soft");
  pen.lineWidth = 1;
  segment(pen, x, y, x + width, y + height);
  segment(pen, x, y + height, x + width, y);
}

// Diagonal lines over boxes: what is unstable can be seen without colour.
function hatchOver(pen, boxes, frame) {
  if (!(pen instanceof SvgPen)) {
    pen.fillStyle = hatching(pen);
    for (const { x, y, width, height } of boxes) pen.fillRect(x, y, width, height);
    return;
  }
  within(pen, boxes, () => {
    pen.strokeStyle = styled("map-hatch");
    pen.lineWidth = 1;
    pen.beginPath();
    for (let x = -frame.height; x < frame.width; x += 6) {
      pen.moveTo(frame.x + x, frame.y + frame.height);
      pen.lineTo(frame.x + x + frame.height, frame.y);
    }
    pen.stroke();
  });
}

// A pattern of diagonal lines, six pixels apart.
function hatching(pen) {
  const ratio = window.devicePixelRatio || 1;
  const tile = document.createElement("canvas");
  const side = Math.round(6 * ratio);
  [tile.width, tile.height] = [side, side];
  const ink = tile.getContext("2d");
  ink.strokeStyle = styled("map-hatch");
  ink.lineWidth = ratio;
  for (const shift of [-side, 0, side]) segment(ink, shift - 1, side + 1, shift + side + 1, -1);
  const pattern = pen.createPattern(tile, "repeat");
  pattern?.setTransform?.(new DOMMatrix([6 / side, 0, 0, 6 / side, 0, 0]));
  return pattern;
}

// Ticks of an axis, pairs of a place from 0 to 1 and a text, and the name of the axis.
function ticksBelow(pen, ticks, left, right, bottom) {
  pen.textAlign = "center";
  pen.textBaseline = "top";
  for (const [unit, text] of ticks) {
    const x = left + unit * (right - left);
    segment(pen, x, bottom, x, bottom + 5);
    pen.fillText(text, x, bottom + 8);
  }
}

function ticksBeside(pen, ticks, left, top, bottom) {
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (const [unit, text] of ticks) {
    const y = bottom - unit * (bottom - top);
    segment(pen, left - 5, y, left, y);
    pen.fillText(text, left - 8, y);
  }
}

function nameBelow(pen, name, left, right, bottom) {
  pen.fillStyle = styled("ink");
  pen.font = `13px ${styled("font")}`;
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  pen.fillText(name, (left + right) / 2, bottom + 38);
}

function nameBeside(pen, name, top, bottom) {
  pen.fillStyle = styled("ink");
  pen.font = `13px ${styled("font")}`;
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  pen.save();
  pen.translate(15, (top + bottom) / 2);
  pen.rotate(-Math.PI / 2);
  pen.fillText(name, 0, 0);
  pen.restore();
}
