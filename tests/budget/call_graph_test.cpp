// The analysis of the stack, on disassemblies made up for it; and the reader of programs, on files that are cut short.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "call_graph.hpp"
#include "elf_file.hpp"
#include "own_folder.hpp"
#include "reader_name.hpp"

namespace zstrip::budget {
namespace {

/// Words from address 0 on; the first 16 are the vector table.
ElfFile program_of(const std::vector<std::uint32_t>& words) {
  Section section{".text", 0, static_cast<std::uint32_t>(words.size() * 4), {}};
  for (const std::uint32_t word : words) {
    for (int shift = 0; shift < 32; shift += 8) section.bytes.push_back(static_cast<std::byte>(word >> shift));
  }
  return {{section}, {}};
}

ElfFile empty_program() { return program_of(std::vector<std::uint32_t>(32)); }

std::uint32_t bound(std::string_view disassembly, const ElfFile& program = empty_program(),
                    const CompilerFrames& frames = {}) {
  return CallGraph(disassembly, program, frames).bound_of("root").bytes;
}

std::string reason(std::string_view disassembly, const ElfFile& program = empty_program(),
                   const CompilerFrames& frames = {}) {
  try {
    bound(disassembly, program, frames);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Budget, StackOfOneFunction) {
  EXPECT_EQ(bound("00000100 <root>:\n     100:\tbx\tlr\n"), 0U);
  EXPECT_EQ(bound("00000100 <root>:\n     100:\tpush\t{r4, r5, lr}\n     102:\tsub\tsp, #108\t@ 0x6c\n"), 120U);
  EXPECT_EQ(bound("00000100 <root>:\n     100:\tstmdb\tsp!, {r4, r5, r6, r7, r8, r9, sl, fp, lr}\n"
                  "     104:\tsub.w\tsp, sp, #948\t@ 0x3b4\n     108:\tadd.w\tsp, sp, #948\t@ 0x3b4\n"
                  "     10c:\tldmia.w\tsp!, {r4, r5, r6, r7, r8, r9, sl, fp, pc}\n"),
            36U + 948);
  EXPECT_EQ(
      bound("00000100 <root>:\n     100:\tstr.w\tlr, [sp, #-4]!\n     104:\tstrd\tip, lr, [sp, #-16]!\n"
            "     108:\tldr.w\tpc, [sp], #4\n     10c:\tstr\tr0, [sp, #8]\n     10e:\tadd\tr3, sp, #1020\t@ 0x3fc\n"),
      20U);
}

TEST(Budget, StackFrameThatIsALiteral) {
  std::vector<std::uint32_t> words(32);
  words[0x48 / 4] = 0xFFFFFBD8;  // -1064
  const std::string_view text =
      "00000040 <root>:\n      40:\tldr\tr4, [pc, #4]\t@ (48 <root+0x8>)\n      42:\tmov\tr8, r3\n"
      "      44:\tadd\tsp, r4\n      46:\tb.n\t40 <root>\n";
  EXPECT_EQ(bound(text, program_of(words)), 1064U);
  // Freed again by a constant that is made in two steps.
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tmovs\tr3, #133\t@ 0x85\n      42:\tlsls\tr3, r3, #3\n"
                  "      44:\tadd\tsp, r3\n"),
            0U);
}

TEST(Budget, StackThatIsNotUnderstoodIsAnError) {
  EXPECT_NE(reason("00000040 <root>:\n      40:\tsub\tsp, r4\n").find("no fixed size"), std::string::npos);
  EXPECT_NE(reason("00000040 <root>:\n      40:\tmov\tsp, r2\n").find("unknown way"), std::string::npos);
  EXPECT_NE(reason("00000040 <root>:\n      40:\tadd\tsp, r2\n").find("unknown amount"), std::string::npos);
  EXPECT_NE(reason("00000040 <root>:\n      40:\tadd\tsp, ip\n").find("unknown amount"), std::string::npos);
  EXPECT_NE(reason("00000040 <root>:\n      40:\tpush\t{r4-r7}\n").find("no list"), std::string::npos);
  EXPECT_NE(reason("00000040 <root>:\n      40:\tmsr\tMSP, r0\n").find("unknown way"), std::string::npos);
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tpush\t{lr}\n      42:\tmsr\tMSPLIM, r3\n"), 4U);
  // In a function that is never reached it does not matter.
  EXPECT_EQ(
      bound(
          "00000040 <root>:\n      40:\tpush\t{lr}\n      42:\tpop\t{pc}\n00000050 <other>:\n      50:\tmov\tsp, r2\n"),
      4U);
}

TEST(Budget, StackIsThatOfTheDeepestPath) {
  const std::string_view text =
      "00000040 <root>:\n      40:\tpush\t{lr}\n      42:\tbl\t60 <shallow>\n      46:\tbl\t80 <deep>\n"
      "00000060 <shallow>:\n      60:\tsub\tsp, #16\n      62:\tbl\ta0 <leaf>\n      66:\tbx\tlr\n"
      "00000080 <deep>:\n      80:\tsub\tsp, #100\t@ 0x64\n      82:\tbhi.w\ta0 <leaf>\n      86:\tb.n\t80 <deep>\n"
      "000000a0 <leaf>:\n      a0:\tsub\tsp, #8\n";
  const CallGraph graph(text, empty_program(), {});
  EXPECT_EQ(graph.bound_of("root").bytes, 4U + 100 + 8);
  EXPECT_EQ(graph.bound_of("root").path, (std::vector<std::string>{"root", "deep", "leaf"}));
  EXPECT_EQ(graph.bound_of("shallow").bytes, 24U);
  EXPECT_THROW(graph.bound_of("missing"), std::runtime_error);
  // Several entries of one piece of assembler: the first goes on to the second. Data behind a return do not.
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tpush\t{lr}\n00000042 <entry>:\n      42:\tsub\tsp, #8\n"), 12U);
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tpop\t{r4, pc}\n      42:\tnop\n      44:\t.word\t0x00000100\n"
                  "00000048 <entry>:\n      48:\tsub\tsp, #8\n"),
            0U);
}

TEST(Budget, StackOfRecursionHasNoBound) {
  EXPECT_EQ(reason("00000040 <root>:\n      40:\tbl\t40 <root>\n"), "root calls itself");
  EXPECT_EQ(reason("00000040 <root>:\n      40:\tbl\t60 <other>\n00000060 <other>:\n      60:\tbl\t40 <root>\n"),
            "root calls itself");
  // Far jumps of Cortex-M0 look like calls, but go into the function itself.
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tpush\t{lr}\n      42:\tbl\t46 <root+0x6>\n      46:\tnop\n"), 4U);
}

// Regression: zeros that align the next function read as `movs r0, r0`, behind which a function seemed to go on.
TEST(Budget, ZerosBehindAReturnDoNotLeadIntoTheNextFunction) {
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tpop\t{r4, pc}\n      42:\tmovs\tr0, r0\n"
                  "00000048 <next>:\n      48:\tbl\t40 <root>\n"),
            0U);
}

// Regression: a routine inside of assembly that moves lr to another register seemed to call through a pointer.
TEST(Budget, ARoutineThatKeepsItsReturnAddressInARegisterReturns) {
  const auto with = [](const std::string& kept) {
    std::vector<std::uint32_t> words(64);
    words[0x50 / 4] = 0x61;
    return bound(
        "00000040 <root>:\n      40:\tpush\t{lr}\n      42:\tbl\t48 <root+0x8>\n      46:\tpop\t{pc}\n      "
        "48:\tmov\t" +
            kept +
            "\n      4a:\tadds\tr1, #1\n      4c:\tbx\tip\n00000060 <pointed>:\n      60:\tsub\tsp, #40\t@ 0x28\n      "
            "62:\tbx\tlr\n",
        program_of(words));
  };
  EXPECT_EQ(with("ip, lr"), 4U);
  EXPECT_EQ(with("ip, r3"), 44U);
}

TEST(Budget, StackBehindPointersIsThatOfAnyFunctionWithAnAddress) {
  const std::string_view text =
      "00000040 <root>:\n      40:\tpush\t{lr}\n      42:\tblx\tr3\n"
      "00000060 <pointed>:\n      60:\tsub\tsp, #40\t@ 0x28\n      62:\tbx\tlr\n"
      "00000080 <never>:\n      80:\tsub\tsp, #400\t@ 0x190\n";
  std::vector<std::uint32_t> words(64);
  words[4] = 0x81;  // in the vector table
  words[40] = 0x61;
  EXPECT_EQ(bound(text, program_of(words)), 44U);
  words[41] = 0x81;
  EXPECT_EQ(bound(text, program_of(words)), 404U);
  // What linkers insert for far branches.
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tldr.w\tpc, [pc]\t@ 44 <root+0x4>\n      44:\t.word\t0x00000061\n"
                  "00000060 <pointed>:\n      60:\tsub\tsp, #40\t@ 0x28\n",
                  program_of(words)),
            40U);
  // A return that takes its address from the stack is none.
  EXPECT_EQ(
      bound("00000080 <root>:\n      80:\tpop\t{r3}\n      82:\tadd\tsp, #8\n      84:\tbx\tr3\n", program_of(words)),
      0U);
}

// Regression: a keyframe of a scene had the value of main's address in one program, which seemed to call itself.
TEST(Budget, ADatumWithTheAddressOfMainIsNoPointerToIt) {
  std::vector<std::uint32_t> words(64);
  words[40] = 0x61;
  const auto called = [&words](const std::string& name) {
    return reason("00000040 <root>:\n      40:\tpush\t{lr}\n      42:\tblx\tr3\n00000060 <" + name +
                      ">:\n      60:\tbl\t40 <root>\n",
                  program_of(words));
  };
  EXPECT_EQ(called("main"), "no error");
  EXPECT_EQ(called("other"), "root calls itself");
}

TEST(Budget, StackIsComparedWithTheCompilersStatement) {
  CompilerFrames frames;
  add_compiler_frames(frames,
                      "graph: { title: \"a.cpp\"\n"
                      "node: { title: \"root\" label: \"void root()\\na.cpp:1:6\\n24 bytes (static)\" }\n"
                      "node: { title: \"a.cpp:_Z5localv\" label: \"void local()\\na.cpp:2:6\\n8 bytes (static)\" }\n"
                      "node: { title: \"memset\" label: \"memset\\n<built-in>\" shape : ellipse }\n"
                      "edge: { sourcename: \"root\" targetname: \"memset\" label: \"a.cpp:3:4\" }\n");
  EXPECT_EQ(frames, (CompilerFrames{{"root", 24}, {"_Z5localv", 8}}));
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tsub\tsp, #24\n", empty_program(), frames), 24U);
  EXPECT_EQ(reason("00000040 <root>:\n      40:\tsub\tsp, #20\n", empty_program(), frames),
            "root: the compiler says that it takes 24 bytes of stack, its instructions say 20");
  add_compiler_frames(frames, "node: { title: \"root\" label: \"void root()\\nb.cpp:1:6\\n20 bytes (static)\" }\n");
  EXPECT_EQ(bound("00000040 <root>:\n      40:\tsub\tsp, #20\n", empty_program(), frames), 20U);
  EXPECT_EQ(reason("00000040 <root>:\n      40:\tsub\tsp, #16\n", empty_program(), frames),
            "root: the compiler says that it takes 20 bytes of stack, its instructions say 16");
  EXPECT_THROW(add_compiler_frames(frames, "node: { title: \"f\" label: \"f\\na.cpp:1:1\\n16 bytes (dynamic)\" }\n"),
               std::runtime_error);
}

TEST(Budget, ProgramsThatAreCutShortAreErrors) {
  const std::filesystem::path program = std::filesystem::path(ZSTRIP_FIRMWARE_BINARIES) / "zstrip_microbit_teapot.elf";
  std::ifstream stream(program, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  EXPECT_GT(read_elf(program).size_of(".text"), 1000U);
  // The headers of sections are the last part of the file.
  const sim::test::OwnFolder folder;
  const std::filesystem::path file = folder.path() / "cut.elf";
  for (std::size_t size = 0; size < bytes.size(); size += size < 128 ? 1 : size / 16) {
    std::ofstream(file, std::ios::binary) << std::string_view(bytes).substr(0, size);
    EXPECT_THROW(read_elf(file), std::runtime_error) << size;
  }
  std::filesystem::remove(file);
  EXPECT_THROW(read_elf(file), std::runtime_error);
}

TEST(Budget, ReaderNamesOfSymbols) {
  EXPECT_EQ(reader_name("memset"), "memset");
  EXPECT_EQ(reader_name("_ZN6zstrip6detail9bounds_ofERKNS0_16CompiledInstanceERKNS0_12RasterOriginERKNS_4ViewEb"),
            "bounds_of");
  EXPECT_EQ(without_arguments("TriangleDepth<(DepthFormat)1>::for_each_run<unsigned short>"),
            "TriangleDepth::for_each_run");
}

}  // namespace
}  // namespace zstrip::budget
