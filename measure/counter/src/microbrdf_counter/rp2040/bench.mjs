// An RP2040 that runs one function, or one instruction, at a time.
//
// It is told what to do line by line, in hexadecimal:
//   load ADDRESS WORD…                      puts words into its flash
//   call ADDRESS WORD… / WORD… / COUNT      calls a function with these arguments and this
//                                           memory, and COUNT words of it that come back
//   step ADDRESS REGISTER CODE…             executes one instruction of one or two halfwords,
//                                           with REGISTER in r0 to r7
// and answers a call by a line of JSON with its results, and addresses and cycles of what it
// executed; a step by its cycles and the address after it, or 0 for what it does not implement.

import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { createInterface } from 'node:readline';

const require = createRequire(join(resolve(process.argv[2]), 'package.json'));
const { RP2040 } = require('rp2040js');

const FLASH = 0x1000_0000;
const RAM = 0x2000_0000;
const STACK_TOP = RAM + 0x2_0000;
const RETURN = 0x0800_0000;
/** More than any kernel takes: one that runs off ends. */
const MOST = 10_000_000;

const chip = new RP2040();
const core = chip.core;
const quiet = () => {};
const fails = (_, text) => {
  throw new Error(text);
};
chip.logger = { debug: quiet, info: quiet, warn: fails, error: fails };

const words = (text) => text.trim().split(' ').filter(Boolean).map((word) => parseInt(word, 16));

function load(text) {
  const [address, ...data] = words(text);
  data.forEach((word, i) => chip.flashView.setUint32(address - FLASH + 4 * i, word, true));
}

function call(text) {
  const [given, memory, count] = text.split('/').map(words);
  const [entry, ...parameters] = given;
  const put = (address, word) => chip.writeUint32(address, word);
  memory.forEach((word, i) => put(RAM + 4 * i, word));
  const back = RAM + 4 * memory.length;
  for (let i = 0; i < count[0]; i++) put(back + 4 * i, 0);
  const onStack = parameters.slice(4);
  // The stack pointer is a multiple of 8 at a call.
  core.SP = STACK_TOP - 8 * Math.ceil(onStack.length / 2);
  onStack.forEach((word, i) => put(core.SP + 4 * i, word));
  parameters.slice(0, 4).forEach((word, i) => {
    core.registers[i] = word;
  });
  core.LR = RETURN | 1;
  core.PC = entry;
  const [addresses, cycles] = [[], []];
  while (core.PC !== RETURN) {
    if (addresses.length >= MOST) throw new Error('it does not return');
    addresses.push(core.PC);
    cycles.push(core.executeInstruction());
  }
  const results = [];
  for (let i = 0; i < count[0]; i++) results.push(chip.readUint32(back + 4 * i) >>> 0);
  return JSON.stringify({ results: count[0] ? results : [...core.registers.slice(0, 2)], addresses, cycles });
}

function step(text) {
  const [address, register, ...code] = words(text);
  code.forEach((half, i) => chip.flashView.setUint16(address - FLASH + 2 * i, half, true));
  core.registers.fill(register, 0, 8);
  core.SP = STACK_TOP;
  core.LR = address | 1;
  core.PC = address;
  core.APSR = 0;
  try {
    const cycles = core.executeInstruction();
    return `${cycles} ${core.PC & ~1}`;
  } catch {
    return '0 0';
  }
}

const commands = { load, call, step };
for await (const line of createInterface({ input: process.stdin })) {
  const space = line.indexOf(' ');
  const answer = commands[line.slice(0, space)](line.slice(space + 1));
  if (answer !== undefined) process.stdout.write(`${answer}\n`);
}
