// The light that an sRGB display makes of a value of 0..255, and the value whose light is nearest.
function lightOfValue(channel) {
  const value = channel / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

function valueOfLight(light) {
  let value = 0;
  while (value < 255 && lightOfValue(value + 1) - light <= light - lightOfValue(value))
    ++value;
  return value;
}

// A run: what happened while a frame was drawn. Its events are the objects of the step log, one after the other. A
// *position* k is the moment after k events; 0 is the cleared frame. The *number* of an event is that of the step log:
// position k stands just after the event with the number k - 1.
class Run {
  // in  a run of the data, its pictures unpacked
  constructor(saved) {
    Object.assign(this, saved);
    this.steps = saved.steps.map(([title, sentence, formula, code, line]) => ({ title, sentence, formula, code, line }));
    this.position = 0;
    this.touched = null; // the pixels that have changed since the picture was drawn last; null: perhaps all
    this.color = new Int32Array(this.samples).fill(colorOf(this.clear[0]));
    this.depth = new Array(this.samples).fill(this.clear[1]);
    if (this.base) {
      this.color = this.base;
      this.depth.fill(null);
    }
    this.hasSamples = this.events.some(event => event.event === "sample");
    this.findTriangles();
    this.readChanges();
  }

  get size() { return this.events.length; }
  // A still has the picture of a moment, not the way to it.
  get isStill() { return Boolean(this.base); }
  // The last event that happened; null at position 0.
  get event() { return this.position === 0 ? null : this.events[this.position - 1]; }
  // Of the last event, as the step log counts.
  get number() { return this.first + this.position - 1; }
  positionOf(number) { return Math.max(0, Math.min(this.size, number - this.first + 1)); }

  // For each event, the events that made the triangle at work and its edge functions; -1 where there is none.
  findTriangles() {
    this.triangleOf = [];
    this.setupOf = [];
    let triangle = -1;
    let setup = -1;
    this.events.forEach((event, i) => {
      const begins = event.event === "vertex" || event.event === "triangle" || event.face === undefined;
      if (begins)
        triangle = setup = -1;
      if (event.event === "triangle")
        triangle = i;
      if (event.event === "setup" && event.edges)
        setup = i;
      this.triangleOf.push(triangle);
      this.setupOf.push(setup);
    });
  }

  // The list of changed samples gets what was there before, so that it can be gone through both ways.
  readChanges() {
    this.changesUpTo = new Array(this.size + 1).fill(0);
    const color = this.color.slice();
    const depth = this.depth.slice();
    this.changes = this.changes.map(([event, sample, newColor, newDepth]) => {
      const change = { sample, color: colorOf(newColor), depth: newDepth, oldColor: color[sample], oldDepth: depth[sample] };
      color[sample] = change.color;
      depth[sample] = change.depth;
      ++this.changesUpTo[event + 1];
      return change;
    });
    for (let k = 1; k <= this.size; ++k)
      this.changesUpTo[k] += this.changesUpTo[k - 1];
  }

  // With a pattern the samples of a number are a picture of one sample a pixel, and these follow each other.
  pixelOf(sample) {
    if (this.pattern > 1)
      return sample % (this.width * this.height);
    return Math.floor(Math.floor(sample / this.columns) / this.grid) * this.width + Math.floor(sample % this.columns / this.grid);
  }

  moveTo(position) {
    position = this.isStill ? this.size : Math.max(0, Math.min(this.size, position));
    const from = this.changesUpTo[this.position];
    const to = this.changesUpTo[position];
    for (let i = Math.min(from, to); this.touched && i < Math.max(from, to); ++i)
      this.touched.push(this.pixelOf(this.changes[i].sample));
    for (let i = from; i < to; ++i) {
      this.color[this.changes[i].sample] = this.changes[i].color;
      this.depth[this.changes[i].sample] = this.changes[i].depth;
    }
    for (let i = from; i-- > to;) {
      this.color[this.changes[i].sample] = this.changes[i].oldColor;
      this.depth[this.changes[i].sample] = this.changes[i].oldDepth;
    }
    this.position = position;
  }

  // 0xRRGGBB of a pixel at this position: with several samples their mean, as the program shows it.
  pixelColor(x, y) {
    const index = y * this.width + x;
    if (this.isStill)
      return this.color[index];
    if (this.finished && this.position > 0 && index < this.resolved[this.position - 1])
      return this.finished[index];
    const samples = this.samplesOf(x, y);
    const half = samples.length >> 1; // the mean is rounded
    const mean = shift => {
      const values = samples.map(sample => sample >> shift & 255);
      if (this.linear)
        return valueOfLight(values.reduce((sum, value) => sum + lightOfValue(value), 0) / samples.length);
      return Math.floor((values.reduce((sum, value) => sum + value, 0) + half) / samples.length);
    };
    return mean(16) << 16 | mean(8) << 8 | mean(0);
  }

  // The colours that the samples of a pixel store.
  samplesOf(x, y) {
    const found = [];
    for (let sample = 0; sample < this.pattern && this.pattern > 1; ++sample)
      found.push(this.color[(sample * this.height + y) * this.width + x]);
    for (let row = y * this.grid; row < (y + 1) * this.grid && this.pattern === 1; ++row)
      for (let column = x * this.grid; column < (x + 1) * this.grid; ++column)
        found.push(this.color[row * this.columns + column]);
    return found;
  }

  // The depth that the sample nearest the pixel's centre stores; null where the page does not have it.
  pixelDepth(x, y) {
    const middle = this.grid >> 1;
    return this.depth[(y * this.grid + middle) * this.columns + x * this.grid + middle];
  }

  // The events at a pixel, ascending.
  eventsAt(x, y) {
    const found = [];
    this.events.forEach((event, i) => {
      if (event.x !== undefined && Math.floor(event.x / this.grid) === x && Math.floor(event.y / this.grid) === y)
        found.push(i);
    });
    return found;
  }

  // The event that tested the sample which an event is about; -1 where there is none.
  testOf(i) {
    const event = this.events[i];
    for (let j = i; j >= 0 && this.triangleOf[j] === this.triangleOf[i]; --j) {
      const other = this.events[j];
      if (other.event === "sample" && other.x === event.x && other.y === event.y)
        return j;
    }
    return -1;
  }
}

function colorOf(text) { return parseInt(text.slice(1), 16); }
function colorText(color) { return "#" + color.toString(16).padStart(6, "0"); }

// Pixels of a packed picture: the channels as differences from the pixel before, as a zlib stream (RFC 1950).
async function pixelsOf(packed, count) {
  const stream = new Response(Uint8Array.from(atob(packed), letter => letter.charCodeAt(0))).body;
  const unpacked = new Response(stream.pipeThrough(new DecompressionStream("deflate")));
  const bytes = new Uint8Array(await unpacked.arrayBuffer());
  const pixels = new Int32Array(count);
  const channels = [0, 0, 0];
  for (let i = 0; i < count; ++i) {
    channels.forEach((former, c) => { channels[c] = former + bytes[channels.length * i + c] & 255; });
    pixels[i] = channels[0] << 16 | channels[1] << 8 | channels[2];
  }
  return pixels;
}

// A run of the data. The browser unpacks its pictures in the background.
async function openRun(saved) {
  const pictures = ["base", "finished", "other"].filter(name => saved[name]);
  const unpacked = await Promise.all(pictures.map(name => pixelsOf(saved[name], saved.width * saved.height)));
  return new Run({ ...saved, ...Object.fromEntries(pictures.map((name, i) => [name, unpacked[i]])) });
}
