// Runs functions on Ibex and says how many cycles they took.
//
// Memory answers a request in the cycle after it. A program of a few
// instructions at the reset vector takes the arguments of a call from a port,
// reads `mcycle` and `minstret`, calls, reads them again and hands all that to
// the port. What the two readings cost by themselves is read first and taken
// off.
//
// Standard input, a line each, numbers in hexadecimal:
//   load ADDRESS WORD…            words of the image
//   call FUNCTION ARGUMENTS… / MEMORY… / COUNT
// A call prints: cycles, instructions, a0, a1, bytes of stack, COUNT words behind MEMORY.

#include <cstdint>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "Vbench.h"
#include "verilated.h"

namespace {

constexpr uint32_t kRam = 0x20000000, kStackTop = kRam + 0x20000, kPort = 0x40000000;
// More than any kernel takes.
constexpr uint64_t kLimit = 50'000'000;

// Registers by their numbers.
enum { zero = 0, ra = 1, sp = 2, t0 = 5, t1 = 6, s0 = 8, s1 = 9, a0 = 10, a1 = 11, s2 = 18, s3 = 19, s4 = 20, s5 = 21 };

uint32_t load(int rd, int base, int at) { return at << 20 | base << 15 | 2 << 12 | rd << 7 | 0x03; }
uint32_t store(int rs, int base, int at) {
  return (at >> 5) << 25 | rs << 20 | base << 15 | 2 << 12 | (at & 31) << 7 | 0x23;
}
uint32_t read_counter(int rd, uint32_t csr) { return csr << 20 | 2 << 12 | rd << 7 | 0x73; }
uint32_t jump(int rd, int to) { return to << 15 | rd << 7 | 0x67; }

constexpr uint32_t kCycles = 0xB00, kRetired = 0xB02;

// Words of the port, by their offsets: what the program takes …
constexpr int kArguments = 0, kStack = 32, kFunction = 36;
// … and what it gives; the last ends the call.
constexpr int kResult = 64, kSecond = 68, kGiven = 72, kDone = 96;

std::vector<uint32_t> program() {
  std::vector<uint32_t> code;
  code.push_back(kPort | t0 << 7 | 0x37);  // lui t0
  const size_t again = code.size();
  for (int i = 0; i < 8; i++) code.push_back(load(a0 + i, t0, kArguments + 4 * i));
  code.push_back(load(sp, t0, kStack));
  code.push_back(load(t1, t0, kFunction));
  // The readings alone; s registers survive the call.
  code.push_back(read_counter(s4, kCycles));
  code.push_back(read_counter(s5, kCycles));
  code.push_back(read_counter(s2, kRetired));
  code.push_back(read_counter(s0, kCycles));
  code.push_back(jump(ra, t1));
  code.push_back(read_counter(s1, kCycles));
  code.push_back(read_counter(s3, kRetired));
  // The function may have used t0.
  code.push_back(kPort | t0 << 7 | 0x37);
  code.push_back(store(a0, t0, kResult));
  code.push_back(store(a1, t0, kSecond));
  const int given[] = {s0, s1, s2, s3, s4, s5};
  for (int i = 0; i < 6; i++) code.push_back(store(given[i], t0, kGiven + 4 * i));
  const uint32_t back = static_cast<uint32_t>(4 * again - 4 * code.size());
  code.push_back((back >> 20 & 1) << 31 | (back >> 1 & 0x3FF) << 21 | (back >> 11 & 1) << 20 |
                 (back >> 12 & 0xFF) << 12 | 0x6F);  // j again
  return code;
}

class Machine {
 public:
  Machine() {
    uint32_t at = 0x80;  // Ibex starts 0x80 behind the boot address.
    for (uint32_t word : program()) {
      write(at, word);
      at += 4;
    }
    // Reset is seen as an edge.
    core_.rst_ni = 1;
    tick();
    core_.rst_ni = 0;
    for (int i = 0; i < 4; i++) tick();
    core_.rst_ni = 1;
  }

  void write(uint32_t at, uint32_t word) { at_address(at) = word; }
  uint32_t read(uint32_t at) { return at_address(at); }

  // Runs one call; false where it did not come back.
  bool call(uint32_t function, const std::vector<uint32_t>& arguments) {
    port_.clear();
    for (size_t i = 0; i < arguments.size(); i++) port_[kArguments + 4 * i] = arguments[i];
    port_[kStack] = kStackTop;
    port_[kFunction] = function;
    done_ = false;
    ready_ = true;
    deepest_ = kStackTop;
    for (uint64_t i = 0; i < kLimit && !done_; i++) tick();
    ready_ = false;
    return done_;
  }

  uint32_t given(int at) { return port_[at]; }
  uint32_t stack() const { return kStackTop - deepest_; }

 private:
  void tick() {
    core_.clk_i = 0;
    core_.eval();
    // What is asked for now is answered in the next cycle. Between calls the
    // port does not answer, and the program waits.
    const bool fetch = core_.instr_req_o;
    const uint32_t fetched = fetch ? at_address(core_.instr_addr_o) : 0;
    if (core_.data_req_o) {
      waits_ = true;
      we_ = core_.data_we_o;
      be_ = core_.data_be_o;
      address_ = core_.data_addr_o & ~3u;
      word_ = core_.data_wdata_o;
    }
    const bool answered = waits_ && (ready_ || address_ < kPort);
    const uint32_t answer = answered ? access() : 0;
    if (answered) waits_ = false;
    core_.clk_i = 1;
    core_.eval();
    core_.instr_rvalid_i = fetch;
    core_.instr_rdata_i = fetched;
    core_.data_rvalid_i = answered;
    core_.data_rdata_i = answer;
  }

  uint32_t access() {
    if (address_ >= kPort) {
      const int at = address_ - kPort;
      if (we_) {
        port_[at] = word_;
        // The last store ends the call, and the port answers again when the next begins.
        if (at == kDone - 4) {
          done_ = true;
          ready_ = false;
        }
        return 0;
      }
      return port_[at];
    }
    uint32_t& word = at_address(address_);
    if (we_) {
      uint32_t mask = 0;
      for (int i = 0; i < 4; i++) mask |= (be_ >> i & 1) ? 0xFFu << 8 * i : 0;
      word = (word & ~mask) | (word_ & mask);
      if (address_ >= kStackTop - 0x10000 && address_ < deepest_) deepest_ = address_;
    }
    return word;
  }

  // Boot memory, flash, RAM; a prefetch past them reads nothing.
  uint32_t& at_address(uint32_t address) {
    for (Region& region : regions_) {
      const uint32_t word = (address - region.base) / 4;
      if (address >= region.base && word < region.words.size()) return region.words[word];
    }
    return nothing_ = 0;
  }

  struct Region {
    uint32_t base;
    std::vector<uint32_t> words;
  };

  Vbench core_;
  std::vector<Region> regions_ = {{0x10000000, std::vector<uint32_t>(1 << 16)},
                                  {kRam, std::vector<uint32_t>(1 << 16)},
                                  {0, std::vector<uint32_t>(1 << 8)}};
  uint32_t nothing_ = 0;
  std::map<int, uint32_t> port_;
  bool done_ = false, ready_ = false, waits_ = false, we_ = false;
  uint32_t be_ = 0, address_ = 0, word_ = 0, deepest_ = kStackTop;
};

std::vector<uint32_t> words(std::istringstream& line) {
  std::vector<uint32_t> found;
  for (std::string word; line >> word && word != "/";)
    found.push_back(static_cast<uint32_t>(std::stoul(word, nullptr, 16)));
  return found;
}

}  // namespace

int main() {
  Machine machine;
  for (std::string text; std::getline(std::cin, text);) {
    std::istringstream line(text);
    std::string command;
    line >> command;
    const std::vector<uint32_t> first = words(line);
    if (command == "load") {
      for (size_t i = 1; i < first.size(); i++) machine.write(first[0] + 4 * (i - 1), first[i]);
      continue;
    }
    const std::vector<uint32_t> memory = words(line), count = words(line);
    for (size_t i = 0; i < memory.size(); i++) machine.write(kRam + 4 * i, memory[i]);
    if (!machine.call(first[0], {first.begin() + 1, first.end()})) {
      std::cerr << "the function does not come back\n";
      return 1;
    }
    const uint32_t alone = machine.given(kGiven + 20) - machine.given(kGiven + 16);
    const uint32_t cycles = machine.given(kGiven + 4) - machine.given(kGiven) - alone;
    // Beside the function's own: two readings before it, the call, one after it.
    const uint32_t retired = machine.given(kGiven + 12) - machine.given(kGiven + 8) - 4;
    std::cout << cycles << ' ' << retired << ' ' << machine.given(kResult) << ' '
              << machine.given(kSecond) << ' ' << machine.stack();
    for (uint32_t i = 0; i < count[0]; i++)
      std::cout << ' ' << machine.read(kRam + 4 * (memory.size() + i));
    std::cout << std::endl;
  }
  return 0;
}
