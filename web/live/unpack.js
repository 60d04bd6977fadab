// Unpacks LZMA (the .lzma files of xz), which is a fifth smaller than what browsers unpack themselves. The numbers are those
// of the LZMA specification of I. Pavlov: a range coder of 11-bit probabilities, and 12 states of what came before.

function unpacked(packed) {
  const properties = packed[0];
  const contextBits = properties % 9;
  const placeMask = (1 << Math.floor(properties / 9) % 5) - 1;
  const stateMask = (1 << Math.floor(properties / 45)) - 1;
  const probabilities = (count) => new Uint16Array(count).fill(1024);
  const lengths = () => ({ choice: probabilities(2), low: probabilities(16 << 3), middle: probabilities(16 << 3), high: probabilities(256) });
  const literals = probabilities(0x300 << (contextBits + Math.floor(properties / 9) % 5));
  const [isMatch, isLongRepeat] = [probabilities(12 << 4), probabilities(12 << 4)];
  const [isRepeat, isRepeat0, isRepeat1, isRepeat2] = Array.from({ length: 4 }, () => probabilities(12));
  const slots = probabilities(4 << 6);
  const [middles, aligned] = [probabilities(128), probabilities(16)];
  const [matchLengths, repeatLengths] = [lengths(), lengths()];

  let [range, code, at] = [0xffffffff, 0, 13];
  for (let i = 0; i < 5; ++i) code = ((code << 8) | packed[at++]) >>> 0;
  const bit = (table, index) => {
    const probability = table[index];
    const bound = (range >>> 11) * probability;
    let result;
    if (code < bound) {
      range = bound;
      table[index] = probability + ((2048 - probability) >> 5);
      result = 0;
    } else {
      range -= bound;
      code -= bound;
      table[index] = probability - (probability >> 5);
      result = 1;
    }
    if (range < 0x1000000) {
      range = (range << 8) >>> 0;
      code = ((code << 8) | packed[at++]) >>> 0;
    }
    return result;
  };
  const evenBits = (count) => {
    let result = 0;
    for (let i = 0; i < count; ++i) {
      range >>>= 1;
      const one = code >= range ? 1 : 0;
      if (one) code -= range;
      if (range < 0x1000000) {
        range = (range << 8) >>> 0;
        code = ((code << 8) | packed[at++]) >>> 0;
      }
      result = result * 2 + one;
    }
    return result;
  };
  const tree = (table, from, bits) => {
    let node = 1;
    for (let i = 0; i < bits; ++i) node = (node << 1) | bit(table, from + node);
    return node - (1 << bits);
  };
  const reversedTree = (table, from, bits) => {
    let [node, result] = [1, 0];
    for (let i = 0; i < bits; ++i) {
      const one = bit(table, from + node);
      node = (node << 1) | one;
      result |= one << i;
    }
    return result;
  };
  const lengthOf = (table, place) =>
    bit(table.choice, 0) === 0 ? tree(table.low, place << 3, 3) : bit(table.choice, 1) === 0 ? 8 + tree(table.middle, place << 3, 3) : 16 + tree(table.high, 0, 8);

  let out = new Uint8Array(1 << 22);
  let [size, state, d0, d1, d2, d3] = [0, 0, 0, 0, 0, 0];
  for (;;) {
    if (at > packed.length) throw new Error("the engine of this page is damaged");
    if (size + 300 > out.length) {
      const larger = new Uint8Array(2 * out.length);
      larger.set(out);
      out = larger;
    }
    const place = size & stateMask;
    if (bit(isMatch, (state << 4) + place) === 0) {
      const before = size > 0 ? out[size - 1] : 0;
      const from = 0x300 * (((size & placeMask) << contextBits) + (before >> (8 - contextBits)));
      let node = 1;
      if (state >= 7) {
        let other = out[size - d0 - 1];
        do {
          const expected = (other >> 7) & 1;
          other <<= 1;
          const one = bit(literals, from + ((1 + expected) << 8) + node);
          node = (node << 1) | one;
          if (one !== expected) break;
        } while (node < 256);
      }
      while (node < 256) node = (node << 1) | bit(literals, from + node);
      out[size++] = node;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length;
    if (bit(isRepeat, state) !== 0) {
      if (bit(isRepeat0, state) === 0) {
        if (bit(isLongRepeat, (state << 4) + place) === 0) {
          out[size] = out[size - d0 - 1];
          size += 1;
          state = state < 7 ? 9 : 11;
          continue;
        }
      } else if (bit(isRepeat1, state) === 0) {
        [d0, d1] = [d1, d0];
      } else if (bit(isRepeat2, state) === 0) {
        [d0, d1, d2] = [d2, d0, d1];
      } else {
        [d0, d1, d2, d3] = [d3, d0, d1, d2];
      }
      length = lengthOf(repeatLengths, place);
      state = state < 7 ? 8 : 11;
    } else {
      [d1, d2, d3] = [d0, d1, d2];
      length = lengthOf(matchLengths, place);
      state = state < 7 ? 7 : 10;
      const slot = tree(slots, Math.min(length, 3) << 6, 6);
      d0 = slot;
      if (slot >= 4) {
        const bits = (slot >> 1) - 1;
        const most = (2 | (slot & 1)) * 2 ** bits;
        d0 = most + (slot < 14 ? reversedTree(middles, most - slot, bits) : evenBits(bits - 4) * 16 + reversedTree(aligned, 0, 4));
      }
      if (d0 === 0xffffffff) return out.subarray(0, size);
      if (d0 >= size) throw new Error("the engine of this page is damaged");
    }
    for (let i = 0; i < length + 2; ++i, ++size) out[size] = out[size - d0 - 1];
  }
}
