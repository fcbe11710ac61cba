// Measures the pipeline of ZSTRIP_EFFECTS on a baked scene that the emulator put into the board's flash, and prints the
// same lines as the benchmark programs for one frame. Each pipeline is a separate program, so that functions are
// compiled as in firmware, which has one pipeline.
#include "mps2/bench_run.hpp"
#include "mps2/scene_in_flash.hpp"

namespace {

using namespace zstrip;

constexpr Effects kEffects{ZSTRIP_EFFECTS};

Renderer<kEffects> renderer;
PixelFormat format_of(std::string_view name) {
  if (name == "gray4") return PixelFormat::gray4;
  return name == "mono" ? PixelFormat::mono : PixelFormat::rgb565;
}

int run(const bench::Arguments& arguments) {
  SceneBlob opened;
  if (const Status status = bench::open_scene_in_flash(opened); !status) return bench::report(status);
  const View view{arguments.width, arguments.height, format_of(arguments.format), opened.view.dither,
                  opened.view.samples};
  const auto [status, plan] = zstrip::plan(count(opened.scene), view, kEffects,
                                           {.bytes = arguments.ram,
                                            .strip_rows = arguments.rows,
                                            .strip_columns = arguments.columns,
                                            .strip_buffers = arguments.buffers,
                                            .modes = kEffects.has(effect::bins) ? Modes::binned : Modes::streamed});
  if (!status) return bench::report(status);
  const std::uint32_t needed = plan.bytes() + plan.strip_pixel_bytes(view);
  if (needed < plan.bytes() || needed > sizeof bench::memory) {
    return bench::report({Error::arena_too_small, Purpose::none, needed, sizeof bench::memory});
  }
  bench::print_configuration(arguments, plan, view);
  scenes::Staged staged;
  staged.scene = opened.scene;
  staged.camera = opened.camera;
  bench::InstructionCounter counter;
  const bench::FrameResult result = bench::run_frame(renderer, staged, view, plan, counter, [] { return Status{}; });
  if (!result.status) {
    bench::print("\n");
    return bench::report(result.status);
  }
  bench::print(", \"frames\": [{\"frame\": 0");
  bench::print_member("instructions", result.instructions);
  bench::print(", \"crc32\": \"");
  bench::print_hex(result.crc32);
  bench::print("\"}]");
  bench::print_member("instructions_per_frame", result.instructions);
  bench::print_member("bin_overflows", renderer.frame().bin_overflows());
  bench::print("}\n");
  return bench::kDone;
}

}  // namespace

int main() { return bench::run_scene("scene_cost", run); }
