// Unpacks what `xz --format=lzma` packed: browsers have only gzip of their own, which packs the
// program by a third worse. LZMA 1 with its header of 13 bytes and a mark at its end.

// Odds of a bit, of 2048, learnt as bits come.
const even = (count) => new Uint16Array(count).fill(1024);

// Bits as a range coder keeps them.
class Bits {
  constructor(bytes, at) {
    this.bytes = bytes;
    // The first byte is always 0.
    this.at = at + 5;
    // Range and code: whole numbers of 32 bits.
    this.both = new Uint32Array([0xffffffff, new DataView(bytes.buffer, bytes.byteOffset).getUint32(at + 1)]);
  }

  refill() {
    const both = this.both;
    if (both[0] < 0x1000000) {
      both[0] <<= 8;
      both[1] = (both[1] << 8) | this.bytes[this.at++];
    }
  }

  bit(odds, place) {
    const both = this.both;
    const is0 = odds[place];
    const bound = Math.imul(both[0] >>> 11, is0) >>> 0;
    let bit = 0;
    if (both[1] < bound) {
      both[0] = bound;
      odds[place] = is0 + ((2048 - is0) >> 5);
    } else {
      both[0] -= bound;
      both[1] -= bound;
      odds[place] = is0 - (is0 >> 5);
      bit = 1;
    }
    this.refill();
    return bit;
  }

  // A number of so many bits, the highest first, each with odds of what came before it.
  number(odds, place, bits) {
    let known = 1;
    for (let left = bits; left > 0; left--) known = (known << 1) | this.bit(odds, place + known);
    return known - (1 << bits);
  }

  // The same, the lowest bit first.
  reversed(odds, place, bits) {
    let known = 1;
    let number = 0;
    for (let at = 0; at < bits; at++) {
      const bit = this.bit(odds, place + known);
      known = (known << 1) | bit;
      number |= bit << at;
    }
    return number;
  }

  // The same without odds.
  plain(bits) {
    const both = this.both;
    let number = 0;
    for (let left = bits; left > 0; left--) {
      both[0] >>>= 1;
      const bit = both[1] >= both[0] ? 1 : 0;
      if (bit) both[1] -= both[0];
      number = (number << 1) | bit;
      this.refill();
    }
    return number;
  }
}

// How long a repeated piece is, less 2.
class Lengths {
  choices = even(2);
  short = even(16 << 3);
  middle = even(16 << 3);
  long = even(1 << 8);

  next(bits, phase) {
    if (!bits.bit(this.choices, 0)) return bits.number(this.short, phase << 3, 3);
    if (!bits.bit(this.choices, 1)) return 8 + bits.number(this.middle, phase << 3, 3);
    return 16 + bits.number(this.long, 0, 8);
  }
}

// How far back a piece stands, less 1; -1 is the mark of the end.
class Distances {
  slots = even(4 << 6);
  near = even(115);
  low = even(1 << 4);

  next(bits, length) {
    const slot = bits.number(this.slots, Math.min(length, 3) << 6, 6);
    if (slot < 4) return slot;
    const more = (slot >> 1) - 1;
    const least = (2 | (slot & 1)) << more;
    if (slot < 14) return least + bits.reversed(this.near, least - slot, more);
    return (least + (bits.plain(more - 4) << 4) + bits.reversed(this.low, 0, 4)) | 0;
  }
}

function unpack(packed) {
  const contextBits = packed[0] % 9;
  const placeMask = (1 << (Math.floor(packed[0] / 9) % 5)) - 1;
  const phaseMask = (1 << Math.floor(packed[0] / 45)) - 1;
  const bits = new Bits(packed, 13);
  const bytes = even(0x300 << (contextBits + Math.floor(packed[0] / 9) % 5));
  const [isPiece, isLonger] = [even(12 << 4), even(12 << 4)];
  const [isKnown, isNotLast, isNotSecond, isNotThird] = [even(12), even(12), even(12), even(12)];
  const [lengths, knownLengths, distances] = [new Lengths(), new Lengths(), new Distances()];
  let out = new Uint8Array(4 * packed.length);
  let at = 0;
  // What the last steps were: below 7 the last one was a byte.
  let state = 0;
  // The last four distances.
  let [last, second, third, fourth] = [0, 0, 0, 0];
  for (;;) {
    if (bits.at > packed.length) throw new Error("the program is damaged");
    if (out.length - at < 273) {
      const larger = new Uint8Array(2 * out.length);
      larger.set(out);
      out = larger;
    }
    const phase = at & phaseMask;
    if (!bits.bit(isPiece, (state << 4) | phase)) {
      const before = at > 0 ? out[at - 1] : 0;
      const place = 0x300 * (((at & placeMask) << contextBits) + (before >> (8 - contextBits)));
      let known = 1;
      if (state >= 7) {
        // Behind a piece: what follows it where it was copied from is a hint.
        let hint = out[at - last - 1];
        while (known < 0x100) {
          const hinted = (hint >> 7) & 1;
          hint <<= 1;
          const bit = bits.bit(bytes, place + ((1 + hinted) << 8) + known);
          known = (known << 1) | bit;
          if (bit !== hinted) break;
        }
      }
      while (known < 0x100) known = (known << 1) | bits.bit(bytes, place + known);
      out[at++] = known;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length;
    if (!bits.bit(isKnown, state)) {
      [second, third, fourth] = [last, second, third];
      length = lengths.next(bits, phase);
      state = state < 7 ? 7 : 10;
      last = distances.next(bits, length);
      if (last === -1) return out.subarray(0, at);
    } else {
      if (!bits.bit(isNotLast, state)) {
        if (!bits.bit(isLonger, (state << 4) | phase)) {
          state = state < 7 ? 9 : 11;
          out[at] = out[at - last - 1];
          at++;
          continue;
        }
      } else if (!bits.bit(isNotSecond, state)) {
        [last, second] = [second, last];
      } else if (!bits.bit(isNotThird, state)) {
        [last, second, third] = [third, last, second];
      } else {
        [last, second, third, fourth] = [fourth, last, second, third];
      }
      length = knownLengths.next(bits, phase);
      state = state < 7 ? 8 : 11;
    }
    if (last >= at) throw new Error("the program is damaged");
    for (const end = at + length + 2; at < end; at++) out[at] = out[at - last - 1];
  }
}
