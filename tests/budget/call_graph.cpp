// Builds the call graph and finds its deepest path.
#include "call_graph.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <set>
#include <stdexcept>

#include "thumb_function.hpp"

namespace zstrip::budget {
namespace {

/// The processor's own entries of the vector table, which stands at the beginning of the first section.
constexpr std::uint32_t kVectorTableBytes = 16 * 4;

/// Every word of the program, the vector table left out, that is the address of a function with the bit for Thumb.
std::set<std::uint32_t> stored_code_addresses(const ElfFile& program) {
  std::set<std::uint32_t> words;
  bool first = true;
  for (const Section& section : program.sections) {
    if (section.bytes.empty()) continue;
    for (std::size_t offset = first ? kVectorTableBytes : 0; offset + 4 <= section.bytes.size(); offset += 4) {
      std::uint32_t word = 0;
      std::memcpy(&word, section.bytes.data() + offset, sizeof word);
      if ((word & 1U) != 0) words.insert(word & ~1U);
    }
    first = false;
  }
  return words;
}

}  // namespace

void add_compiler_frames(CompilerFrames& frames, std::string_view ci) {
  constexpr std::string_view kTitle = "node: { title: \"", kLabel = "\" label: \"", kBytes = " bytes (";
  for (std::size_t begin = 0; begin < ci.size();) {
    const std::size_t end = std::min(ci.find('\n', begin), ci.size());
    const std::string_view line = ci.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t bytes = line.rfind(kBytes);
    const std::size_t label = line.find(kLabel);
    if (!line.starts_with(kTitle) || label == std::string_view::npos || bytes == std::string_view::npos) continue;
    // Of functions that only their file knows, the title begins with the file.
    std::string_view name = line.substr(kTitle.size(), label - kTitle.size());
    name.remove_prefix(name.rfind(':') == std::string_view::npos ? 0 : name.rfind(':') + 1);
    if (!line.substr(bytes + kBytes.size()).starts_with("static")) {
      throw std::runtime_error(demangled(std::string(name)) + ": the compiler knows no fixed frame");
    }
    const std::size_t digits = line.rfind("\\n", bytes) + 2;
    std::uint32_t frame = 0;
    std::from_chars(line.data() + digits, line.data() + bytes, frame);
    const auto [known, is_new] = frames.emplace(name, frame);
    if (!is_new) known->second = std::min(known->second, frame);
  }
}

CallGraph::CallGraph(std::string_view disassembly, const ElfFile& program, const CompilerFrames& compiler_frames) {
  std::vector<ThumbFunction> parsed = parse_disassembly(disassembly);
  std::stable_sort(parsed.begin(), parsed.end(), [](const auto& a, const auto& b) { return a.address < b.address; });
  for (const ThumbFunction& each : parsed) {
    Function& function = functions_.emplace_back(Function{.name = each.name, .address = each.address});
    try {
      function.frame = stack_frame(each, program);
    } catch (const std::runtime_error& error) {
      function.unknown = error.what();
      continue;
    }
    const auto stated = compiler_frames.find(each.name);
    if (stated != compiler_frames.end() && stated->second > function.frame) {
      throw std::runtime_error(demangled(each.name) + ": the compiler says that it takes " +
                               std::to_string(stated->second) + " bytes of stack, its instructions say " +
                               std::to_string(function.frame));
    }
  }

  const auto function_at = [&](std::uint32_t address) {
    const auto after = std::upper_bound(functions_.begin(), functions_.end(), address,
                                        [](std::uint32_t a, const Function& f) { return a < f.address; });
    if (after == functions_.begin()) throw std::runtime_error("a call to no function: " + std::to_string(address));
    return static_cast<std::size_t>(after - functions_.begin()) - 1;
  };
  const std::set<std::uint32_t> stored = stored_code_addresses(program);
  for (std::size_t index = 0; index < parsed.size(); ++index) {
    const Targets targets = targets_of(parsed[index]);
    std::set<std::size_t> callees;
    for (const std::uint32_t address : targets.addresses) callees.insert(function_at(address));
    if (targets.next && index + 1 < parsed.size()) callees.insert(index + 1);
    if (targets.through_pointer) {
      for (std::size_t other = 0; other < functions_.size(); ++other) {
        // C++ forbids taking the address of main: a word with its value is other data.
        if (functions_[other].name != "main" && stored.contains(functions_[other].address)) callees.insert(other);
      }
    }
    functions_[index].callees.assign(callees.begin(), callees.end());
  }
}

std::size_t CallGraph::index_of(const std::string& function) const {
  for (std::size_t index = 0; index < functions_.size(); ++index) {
    if (functions_[index].name == function) return index;
  }
  throw std::runtime_error("there is no function " + function);
}

StackBound CallGraph::bound_of(const std::string& function) const {
  std::vector<State> states(functions_.size(), State::unseen);
  std::vector<StackBound> bounds(functions_.size());
  return deepest(index_of(function), states, bounds);
}

const StackBound& CallGraph::deepest(std::size_t index, std::vector<State>& states,
                                     std::vector<StackBound>& bounds) const {
  const Function& function = functions_[index];
  if (!function.unknown.empty()) throw std::runtime_error(function.unknown);
  if (states[index] == State::active) throw std::runtime_error(demangled(function.name) + " calls itself");
  if (states[index] == State::done) return bounds[index];
  states[index] = State::active;
  StackBound deepest_callee;
  for (const std::size_t callee : function.callees) {
    const StackBound& bound = deepest(callee, states, bounds);
    if (bound.bytes >= deepest_callee.bytes) deepest_callee = bound;
  }
  StackBound& result = bounds[index];
  result.bytes = function.frame + deepest_callee.bytes;
  result.path = {function.name};
  result.path.insert(result.path.end(), deepest_callee.path.begin(), deepest_callee.path.end());
  states[index] = State::done;
  return result;
}

}  // namespace zstrip::budget
