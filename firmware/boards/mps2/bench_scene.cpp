// The benchmark of a lit mesh in a baked scene that the emulator puts into the board's flash, for models from a
// package. The mesh rotates like the built-in workloads. Prints the same lines as the other benchmark programs.
#include "mps2/bench_run.hpp"
#include "mps2/scene_in_flash.hpp"

namespace {

using namespace zstrip;

constexpr Effects kEffects = effect::lighting | effect::gouraud | effect::shade_gouraud;

Renderer<kEffects> renderer;
scenes::Staged staged;

int run(const bench::Arguments& arguments) {
  SceneBlob opened;
  if (const Status status = bench::open_scene_in_flash(opened); !status) return bench::report(status);
  scenes::BuiltIn model{};
  model.scene = opened.scene;
  const View view{arguments.width, arguments.height, PixelFormat::rgb565};
  const auto [status, plan] = zstrip::plan(count(opened.scene), view, kEffects,
                                           {.bytes = arguments.ram,
                                            .strip_rows = arguments.rows,
                                            .strip_columns = arguments.columns,
                                            .strip_buffers = arguments.buffers});
  if (!status) return bench::report(status);
  const std::uint32_t needed = plan.bytes() + plan.strip_pixel_bytes(view);
  if (needed < plan.bytes() || needed > sizeof bench::memory) {
    return bench::report({Error::arena_too_small, Purpose::none, needed, sizeof bench::memory});
  }
  bench::InstructionCounter counter;
  bench::print_configuration(arguments, plan, view);
  bench::print(", \"frames\": [");
  std::uint64_t total = 0;
  for (std::uint32_t i = 0; i < arguments.frames; ++i) {
    const std::uint32_t frame = arguments.first + i;
    scenes::stage_workload(model, staged, frame);
    const bench::FrameResult result = bench::run_frame(renderer, staged, view, plan, counter, [] { return Status{}; });
    if (!result.status) {
      bench::print("\n");
      return bench::report(result.status);
    }
    bench::print(i == 0 ? "{\"frame\": " : ", {\"frame\": ");
    bench::print_decimal(frame);
    bench::print_member("instructions", result.instructions);
    bench::print(", \"crc32\": \"");
    bench::print_hex(result.crc32);
    bench::print("\"}");
    total += result.instructions;
  }
  bench::print("]");
  bench::print_member("instructions_per_frame", total / arguments.frames);
  bench::print_member("bin_overflows", renderer.frame().bin_overflows());
  bench::print_member("stack_bytes", board::stack_bytes_used());
  bench::print("}\n");
  return bench::kDone;
}

}  // namespace

int main() {
  constexpr bench::Workload kWorkloads[] = {{"bunny", "z16", run}};
  return bench::run_bench(kWorkloads);
}
