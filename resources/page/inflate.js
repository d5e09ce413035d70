// Undoes the compression of pictures: DEFLATE (RFC 1951) within a zlib stream (RFC 1950). Browsers do it themselves, but
// only in the background, and a page is to stand at once.

// The bits of a stream, the lowest of a byte first, and the words of its prefix codes.
class Bits {
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
    this.bit = 0;
  }

  next(count) {
    let value = 0;
    for (let i = 0; i < count; ++i) {
      value |= (this.bytes[this.at] >> this.bit & 1) << i;
      this.bit = (this.bit + 1) % 8;
      this.at += this.bit === 0 ? 1 : 0;
    }
    return value;
  }

  skipToByte() {
    this.at += this.bit > 0 ? 1 : 0;
    this.bit = 0;
  }

  // The words of one length are consecutive numbers, and those of the next length follow them with a bit appended.
  symbol(code) {
    let word = 0;
    let first = 0;
    let index = 0;
    for (let length = 1; length < code.counts.length; ++length) {
      word |= this.next(1);
      const count = code.counts[length];
      if (word - first < count)
        return code.symbols[index + word - first];
      index += count;
      first = first + count << 1;
      word <<= 1;
    }
    throw new Error("a picture of this page is damaged");
  }
}

// in  the length of each symbol's word in bits; 0: the symbol does not occur
function prefixCode(lengths) {
  const kMostBits = 15;
  const counts = new Array(kMostBits + 1).fill(0);
  const symbols = [];
  for (let length = 1; length <= kMostBits; ++length)
    lengths.forEach((ofSymbol, symbol) => {
      if (ofSymbol !== length)
        return;
      symbols.push(symbol);
      ++counts[length];
    });
  return { counts, symbols };
}

const kFixedCodes = {
  literals: prefixCode(Array.from({ length: 288 }, (_, i) => i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8)),
  distances: prefixCode(new Array(30).fill(5)),
};

// The codes of a block that has its own: their lengths are coded themselves.
function readCodes(bits) {
  const kOrder = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
  const literals = bits.next(5) + 257;
  const distances = bits.next(5) + 1;
  const given = bits.next(4) + 4;
  const ofLengths = new Array(kOrder.length).fill(0);
  for (let i = 0; i < given; ++i)
    ofLengths[kOrder[i]] = bits.next(3);
  const code = prefixCode(ofLengths);
  const lengths = [];
  while (lengths.length < literals + distances) {
    const symbol = bits.symbol(code);
    if (symbol < 16)
      lengths.push(symbol);
    else if (symbol === 16)
      lengths.push(...new Array(bits.next(2) + 3).fill(lengths[lengths.length - 1]));
    else
      lengths.push(...new Array(symbol === 17 ? bits.next(3) + 3 : bits.next(7) + 11).fill(0));
  }
  return { literals: prefixCode(lengths.slice(0, literals)), distances: prefixCode(lengths.slice(literals)) };
}

// Lengths of copies from symbol 257 on: groups of four symbols, each group with one extra bit more. Distances: of two.
function copyLength(bits, symbol) {
  const group = symbol - 257;
  if (group < 8 || group === 28)
    return group < 8 ? group + 3 : 258;
  const extra = (group >> 2) - 1;
  return (4 + group % 4 << extra) + 3 + bits.next(extra);
}
function copyDistance(bits, symbol) {
  if (symbol < 4)
    return symbol + 1;
  const extra = (symbol >> 1) - 1;
  return (2 + symbol % 2 << extra) + 1 + bits.next(extra);
}

// in  the bytes of a zlib stream, and how many bytes come out of it
function inflated(bytes, size) {
  const out = new Uint8Array(size);
  const kHeader = 2; // bytes of zlib
  const bits = new Bits(bytes, kHeader);
  let end = 0;
  for (let isLast = false; !isLast;) {
    isLast = bits.next(1) === 1;
    const kind = bits.next(2);
    if (kind === 0) {
      bits.skipToByte();
      const length = bits.next(16);
      bits.next(16); // the same once more, inverted
      out.set(bytes.subarray(bits.at, bits.at + length), end);
      bits.at += length;
      end += length;
      continue;
    }
    const codes = kind === 1 ? kFixedCodes : readCodes(bits);
    const kEndOfBlock = 256;
    for (let symbol = bits.symbol(codes.literals); symbol !== kEndOfBlock; symbol = bits.symbol(codes.literals)) {
      if (symbol < kEndOfBlock) {
        out[end++] = symbol;
        continue;
      }
      const length = copyLength(bits, symbol);
      const distance = copyDistance(bits, bits.symbol(codes.distances));
      for (let i = 0; i < length; ++i, ++end)
        out[end] = out[end - distance];
    }
  }
  return out;
}
