// Draws the picture: its pixels as sharp squares, the triangle at work, the signs of the samples, what is selected.
const kInk = "#12151a";
const kPlusColor = "#005a8c";
const kMinusColor = "#8f3c00";
// Of the edges AB, BC, CA: colour on the canvas and dashes, in widths of the line.
const kEdgeLooks = [["#6a3d9a", []], ["#005f54", [3, 1.5]], ["#6f4700", [1, 1]]];
const kGlyphsFrom = 30; // side of a sample on the screen from which the three signs are drawn
const kGridFrom = 8;
const kDotsFrom = 14;
const kLargeBelow = 16; // a picture with smaller pixels is shown in parts

const kMargin = 11; // about the picture, for lines and letters at its border

const kZoomed = 32; // side of a pixel where a part of a large picture is shown

// How large a pixel of the picture is on the canvas, and the pixels that are shown: all, or those about the step.
const view = { side: 1, left: 0, top: 0, width: 1, height: 1, isPart: false };

// Gives a canvas a size and makes its units those of the page.
function fitCanvas(canvas, width, height) {
  const scale = window.devicePixelRatio || 1;
  canvas.width = Math.round(width * scale);
  canvas.height = Math.round(height * scale);
  canvas.style.width = width + "px";
  canvas.style.height = height + "px";
  const pen = canvas.getContext("2d");
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  return pen;
}

// A line in its colour above a wider, lighter one, so that it shows on every picture.
function strokeSeamed(pen, color, width, dash, seam) {
  pen.setLineDash([]);
  pen.strokeStyle = seam;
  pen.lineWidth = width + 2.5;
  pen.stroke();
  pen.setLineDash(dash.map(length => length * width));
  pen.strokeStyle = color;
  pen.lineWidth = width;
  pen.stroke();
  pen.setLineDash([]);
}

// A picture of a run, a pixel for each of its pixels.
function smallPicture(run) {
  const canvas = document.createElement("canvas");
  canvas.width = run.width;
  canvas.height = run.height;
  return { run, canvas, image: canvas.getContext("2d").createImageData(run.width, run.height) };
}

function putPixel(image, i, color) {
  image.data[4 * i] = color >> 16;
  image.data[4 * i + 1] = color >> 8 & 255;
  image.data[4 * i + 2] = color & 255;
  image.data[4 * i + 3] = 255;
}

// The picture that was drawn last: the next one of this run changes only some of its pixels.
let lastPicture = null;

function drawPixels(pen, run, colors, side) {
  if (!lastPicture || lastPicture.run !== run || colors || run.finished)
    run.touched = null;
  if (!lastPicture || lastPicture.run !== run)
    lastPicture = smallPicture(run);
  const { canvas, image } = lastPicture;
  const touched = run.touched || Array(run.width * run.height).keys();
  for (const i of touched)
    putPixel(image, i, colors ? colors[i] : run.pixelColor(i % run.width, Math.floor(i / run.width)));
  run.touched = colors ? null : [];
  canvas.getContext("2d").putImageData(image, 0, 0);
  pen.imageSmoothingEnabled = side < 1;
  const { left, top, width, height } = view;
  pen.drawImage(canvas, left, top, width, height, left * side, top * side, width * side, height * side);
}

function drawGrid(pen, side) {
  if (side < kGridFrom)
    return;
  pen.strokeStyle = "rgba(128, 134, 144, 0.65)";
  pen.lineWidth = 1;
  pen.beginPath();
  const right = view.left + view.width;
  const bottom = view.top + view.height;
  for (let x = view.left; x <= right; ++x) {
    pen.moveTo(x * side, view.top * side);
    pen.lineTo(x * side, bottom * side);
  }
  for (let y = view.top; y <= bottom; ++y) {
    pen.moveTo(view.left * side, y * side);
    pen.lineTo(right * side, y * side);
  }
  pen.stroke();
}

// A disc with the sign of an edge function: plus inside, minus outside, a ring on the edge.
function drawGlyph(pen, x, y, diameter, value, edge) {
  const radius = diameter / 2;
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fillStyle = value > 0 ? kPlusColor : value < 0 ? kMinusColor : "#ffffff";
  pen.fill();
  pen.strokeStyle = kEdgeLooks[edge][0];
  pen.lineWidth = Math.max(1, diameter / 9);
  pen.stroke();
  pen.strokeStyle = value === 0 ? "#000000" : "#ffffff";
  pen.lineWidth = Math.max(1, diameter / 7);
  pen.beginPath();
  if (value === 0) {
    pen.ellipse(x, y, radius * 0.3, radius * 0.45, 0, 0, 2 * Math.PI);
  } else {
    pen.moveTo(x - radius / 2, y);
    pen.lineTo(x + radius / 2, y);
    if (value > 0) {
      pen.moveTo(x, y - radius / 2);
      pen.lineTo(x, y + radius / 2);
    }
  }
  pen.stroke();
}

// The signs of a sample that was tested, in a square of the given side: one for each edge about the sample.
function drawSigns(pen, x, y, side, values) {
  const diameter = Math.min(22, side * 0.3);
  const places = [[0.5, 0.24], [0.24, 0.74], [0.76, 0.74]];
  values.forEach((value, edge) =>
    drawGlyph(pen, x + places[edge][0] * side, y + places[edge][1] * side, diameter, value, edge));
}

function drawDot(pen, x, y, radius) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fillStyle = kInk;
  pen.strokeStyle = "#ffffff";
  pen.lineWidth = 1;
  pen.fill();
  pen.stroke();
}

// What was found about the samples of the triangle at work, up to the present step.
function drawSamples(pen, run, side) {
  const sampleSide = side / run.grid;
  if (sampleSide < kGridFrom)
    return;
  const tested = new Set();
  const now = run.position - 1;
  const triangle = now < 0 ? -1 : run.triangleOf[now];
  for (let i = now; triangle >= 0 && i > triangle; --i) {
    const event = run.events[i];
    if (event.event !== "sample" || tested.has(event.y * run.columns + event.x))
      continue;
    tested.add(event.y * run.columns + event.x);
    if (lesson.isSecret(Math.floor(event.x / run.grid), Math.floor(event.y / run.grid)))
      continue;
    if (sampleSide >= kGlyphsFrom)
      drawSigns(pen, event.x * sampleSide, event.y * sampleSide, sampleSide, event.values);
    else
      drawGlyph(pen, (event.x + 0.5) * sampleSide, (event.y + 0.5) * sampleSide, sampleSide * 0.6,
                event.tie ? 0 : event.covered ? 1 : -1, 0);
  }
  if (sampleSide < kDotsFrom)
    return;
  for (let row = view.top * run.grid; row < (view.top + view.height) * run.grid; ++row)
    for (let column = view.left * run.grid; column < (view.left + view.width) * run.grid; ++column)
      if (!tested.has(row * run.columns + column) || sampleSide >= kGlyphsFrom)
        drawDot(pen, (column + 0.5) * sampleSide, (row + 0.5) * sampleSide, Math.max(1.5, Math.min(3, sampleSide / 16)));
}

// The corners of a triangle, in samples.
function cornersOf(event) { return event.vertices.map(vertex => vertex.screen); }

// The edges of the triangle at work: pairs of corners, in the order of the set-up where there is one.
function edgesOf(run, i) {
  const setup = run.setupOf[i];
  const names = setup < 0 ? ["AB", "BC", "CA"] : run.events[setup].edges.map(edge => edge.edge);
  return names.map(name => [...name].map(letter => "ABC".indexOf(letter)));
}

function drawTriangles(pen, run, side) {
  const scale = side / run.grid;
  const now = run.position - 1;
  const atWork = now < 0 ? -1 : run.triangleOf[now];
  for (let i = 0; i <= now; ++i) {
    if (run.events[i].event !== "triangle" || i === atWork)
      continue;
    pen.beginPath();
    cornersOf(run.events[i]).forEach(([x, y]) => pen.lineTo(x * scale, y * scale));
    pen.closePath();
    strokeSeamed(pen, "#f5f7fa", 1, [], kInk);
  }
  if (atWork < 0)
    return;
  const corners = cornersOf(run.events[atWork]);
  edgesOf(run, now).forEach(([from, to], edge) => {
    pen.beginPath();
    pen.moveTo(corners[from][0] * scale, corners[from][1] * scale);
    pen.lineTo(corners[to][0] * scale, corners[to][1] * scale);
    strokeSeamed(pen, kEdgeLooks[edge][0], 3, kEdgeLooks[edge][1], "#ffffff");
  });
}

// The names of the corners, moved a little away from the middle of the triangle, on plates within the canvas.
function drawLetters(pen, run, side) {
  const triangle = run.position === 0 ? -1 : run.triangleOf[run.position - 1];
  if (triangle < 0)
    return;
  const corners = cornersOf(run.events[triangle]);
  const scale = side / run.grid;
  const kSmallest = 40; // of a triangle that has room for letters
  const size = axis => Math.max(...corners.map(corner => corner[axis])) - Math.min(...corners.map(corner => corner[axis]));
  if (Math.max(size(0), size(1)) * scale < kSmallest)
    return;
  const [left, top] = [view.left * side, view.top * side];
  const [right, bottom] = [left + view.width * side, top + view.height * side];
  const middle = [0, 1].map(axis => corners.reduce((sum, corner) => sum + corner[axis], 0) / 3);
  pen.font = "bold 14px sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  corners.forEach((corner, i) => {
    const isShown = [[left, right], [top, bottom]].every(([from, to], axis) =>
      corner[axis] * scale >= from && corner[axis] * scale <= to);
    if (view.isPart && !isShown)
      return;
    const place = [0, 1].map(axis => corner[axis] * scale + Math.sign(corner[axis] - middle[axis]) * 12);
    const x = Math.max(left, Math.min(right, place[0]));
    const y = Math.max(top, Math.min(bottom, place[1]));
    pen.fillStyle = kInk;
    pen.beginPath();
    pen.arc(x, y, 10, 0, 2 * Math.PI);
    pen.fill();
    pen.fillStyle = "#ffffff";
    pen.fillText("ABC"[i], x, y + 1);
  });
}

function frame(pen, x, y, width, height, color, line) {
  pen.setLineDash([]);
  pen.strokeStyle = kInk;
  pen.lineWidth = line + 2;
  pen.strokeRect(x, y, width, height);
  pen.strokeStyle = color;
  pen.lineWidth = line;
  pen.strokeRect(x, y, width, height);
}

// What the present event is about: a sample, or the samples of a span.
function drawEvent(pen, run, side) {
  const event = run.event;
  const sampleSide = side / run.grid;
  if (!event)
    return;
  if (event.event === "span" && event.x_end > event.x_begin)
    frame(pen, event.x_begin * sampleSide, event.y * sampleSide, (event.x_end - event.x_begin) * sampleSide, sampleSide,
          "#f0e442", 3);
  else if (event.event === "crossing")
    [event.xa, event.xb].forEach(x => drawDot(pen, x * sampleSide, (event.y + 0.5) * sampleSide, 5));
  else if (event.event === "resolve")
    frame(pen, event.pixel[0] * side, event.pixel[1] * side, side, side, "#f0e442", 3);
  else if (event.x !== undefined && event.y !== undefined)
    frame(pen, event.x * sampleSide, event.y * sampleSide, sampleSide, sampleSide, "#f0e442", 3);
}

function drawMark(pen, x, y, side) {
  frame(pen, x * side + 3, y * side + 3, side - 6, side - 6, "#ffffff", 3);
  pen.beginPath();
  pen.moveTo((x + 0.28) * side, (y + 0.55) * side);
  pen.lineTo((x + 0.45) * side, (y + 0.72) * side);
  pen.lineTo((x + 0.76) * side, (y + 0.3) * side);
  strokeSeamed(pen, "#ffffff", Math.max(2, side / 14), [], kInk);
}

// Where the present step is, in pixels: at its sample, or in the middle of the triangle at work; else at the chosen
// pixel; null: nowhere.
function placeOfStep(run, pixel) {
  const event = run.event;
  if (event && event.x !== undefined && event.y !== undefined)
    return [event.x / run.grid, event.y / run.grid];
  const triangle = event ? run.triangleOf[run.position - 1] : -1;
  if (triangle >= 0)
    return [0, 1].map(axis => cornersOf(run.events[triangle]).reduce((sum, at) => sum + at[axis], 0) / 3 / run.grid);
  return pixel;
}

// Chooses the pixels that are shown. A part of a large picture stays where it is while the step is well within it.
function chooseView(run, shown) {
  const place = byId("place");
  const [width, height] = [place.clientWidth - 2 * kMargin, place.clientHeight - 2 * kMargin];
  const room = Math.min(width / run.width, height / run.height);
  view.isLarge = room < kLargeBelow;
  const step = placeOfStep(run, shown.pixel);
  if (!view.isLarge || !shown.zooms || !step) {
    const side = room >= 2 ? Math.floor(room) : Math.max(room, 1 / 64);
    Object.assign(view, { side, left: 0, top: 0, width: run.width, height: run.height, isPart: false });
    return;
  }
  const part = [Math.floor(width / kZoomed), Math.floor(height / kZoomed)];
  const whole = [run.width, run.height];
  const kBorder = 3;
  const former = [view.left, view.top];
  const [left, top] = step.map((at, axis) => {
    const isWithin = at >= former[axis] + kBorder && at < former[axis] + part[axis] - kBorder;
    const from = view.isPart && isWithin ? former[axis] : Math.round(at - part[axis] / 2);
    return Math.max(0, Math.min(whole[axis] - part[axis], from));
  });
  Object.assign(view, { side: kZoomed, left, top, isPart: true,
                        width: Math.min(part[0], run.width), height: Math.min(part[1], run.height) });
}

// Draws all of it, as large as the place beside the texts allows.
function drawPicture(run, shown) {
  byId("place").style.setProperty("--ratio", run.height / run.width); // a narrow screen gives no more height than that
  chooseView(run, shown);
  const side = view.side;
  const canvas = byId("picture");
  const pen = fitCanvas(canvas, Math.ceil(view.width * side) + 2 * kMargin, Math.ceil(view.height * side) + 2 * kMargin);
  pen.translate(kMargin - view.left * side, kMargin - view.top * side);
  if (view.isPart) {
    pen.beginPath();
    pen.rect(view.left * side, view.top * side, view.width * side, view.height * side);
    pen.clip();
  }
  drawPixels(pen, run, shown.compares ? run.other : null, side);
  drawGrid(pen, side);
  if (!shown.compares) {
    drawTriangles(pen, run, side);
    drawSamples(pen, run, side);
    drawEvent(pen, run, side);
    drawLetters(pen, run, side);
  }
  if (shown.pixel)
    frame(pen, shown.pixel[0] * side + 2, shown.pixel[1] * side + 2, Math.max(2, side - 4), Math.max(2, side - 4), "#56b4e9", 2);
  for (const pixel of shown.marks)
    drawMark(pen, pixel % run.width, Math.floor(pixel / run.width), side);
}

// The lens: the sample of the present step and its neighbours, enlarged, with the edges that pass by.
function drawLens(run, test) {
  const event = run.events[test];
  const kSide = 150;
  const kShown = 3; // samples across
  const scale = kSide / kShown;
  const pen = fitCanvas(byId("lens-picture"), kSide, kSide);
  byId("lens-picture").removeAttribute("style");
  pen.fillStyle = kInk;
  pen.fillRect(0, 0, kSide, kSide);
  pen.translate(-(event.x - 1) * scale, -(event.y - 1) * scale);
  for (let y = event.y - 1; y <= event.y + 1; ++y)
    for (let x = event.x - 1; x <= event.x + 1; ++x) {
      if (x < 0 || y < 0 || x >= run.columns || y >= run.rows)
        continue;
      pen.fillStyle = colorText(run.color[y * run.columns + x]);
      pen.fillRect(x * scale, y * scale, scale, scale);
      pen.strokeStyle = "rgba(128, 134, 144, 0.8)";
      pen.lineWidth = 1;
      pen.strokeRect(x * scale, y * scale, scale, scale);
      drawDot(pen, (x + 0.5) * scale, (y + 0.5) * scale, 3);
    }
  const corners = cornersOf(run.events[run.triangleOf[test]]);
  edgesOf(run, test).forEach(([from, to], edge) => {
    pen.beginPath();
    pen.moveTo(corners[from][0] * scale, corners[from][1] * scale);
    pen.lineTo(corners[to][0] * scale, corners[to][1] * scale);
    strokeSeamed(pen, kEdgeLooks[edge][0], 3, kEdgeLooks[edge][1], "#ffffff");
  });
  drawSigns(pen, event.x * scale, event.y * scale, scale, event.values);
  drawDot(pen, (event.x + 0.5) * scale, (event.y + 0.5) * scale, 3.5);
  frame(pen, event.x * scale, event.y * scale, scale, scale, "#f0e442", 3);
}
