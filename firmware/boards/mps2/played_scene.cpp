// Counts frames of a baked scene that the emulator put into the board's flash, with the pipeline of ZSTRIP_EFFECTS and
// the motion of the scene: clips, morph targets, levels of detail, or a rotation. Prints the same lines as the
// benchmark programs.
#include <algorithm>
#include <memory>

#include "mps2/bench_run.hpp"
#include "mps2/scene_in_flash.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace {

using namespace zstrip;

constexpr Effects kEffects{ZSTRIP_EFFECTS};
constexpr std::size_t kDrawn =
    2'000'000;  // bytes of the memory for arena and pixels; the rest is for tables and motion

Renderer<kEffects> renderer;
scenes::Staged staged;

class PlayedScene {
 public:
  Status open() {
    const std::span<std::byte> tables = std::span(bench::memory).subspan(kDrawn);
    if (const Status status = open_scene_blob(bench::blob_in_flash(), tables, blob_); !status) return status;
    const std::size_t used = (blob_.memory_bytes + kArenaAlignment - 1) / kArenaAlignment * kArenaAlignment;
    const std::size_t instances = blob_.scene.instances.size(), lines = blob_.scene.lines.size();
    const std::size_t needed = used + instances * sizeof(Instance) + lines * sizeof(LineSet);
    if (needed > tables.size()) {
      return {Error::arena_too_small, Purpose::none, static_cast<std::uint32_t>(needed),
              static_cast<std::uint32_t>(tables.size())};
    }
    auto* const first = reinterpret_cast<LineSet*>(tables.data() + used);
    std::uninitialized_default_construct_n(first, lines);
    auto* const moved = reinterpret_cast<Instance*>(first + lines);
    std::uninitialized_default_construct_n(moved, instances);
    parts_ = {{moved, instances}, {first, lines}};
    return {};
  }
  const SceneBlob& blob() const { return blob_; }

  /// Moves the scene as the host does for frame `frame` of `frames` frames.
  Status place(std::uint32_t frame, std::uint32_t frames) {
    Animation animation = blob_.animation;
    if (!blob_.clips.empty()) {
      animation = blob_.clips.front().instances;
      const PlayedClip played{.time = time_of_frame(animation, frame, frames)};
      if (const Status posed = pose_clips(blob_, {&played, 1}); !posed) return posed;
    }
    const scenes::BakedFrame placed = scenes::stage(
        {blob_.scene, blob_.camera_for(frames), animation, blob_.turn, blob_.levels}, frame, frames, parts_);
    staged.scene = placed.scene;
    staged.camera = placed.camera;
    return {};
  }

 private:
  SceneBlob blob_;
  scenes::MovedParts parts_;
};

int run(const bench::Arguments& arguments) {
  static PlayedScene scene;
  if (const Status status = scene.open(); !status) return bench::report(status);
  const View view = scene.blob().view;
  const auto [status, plan] = zstrip::plan(count(scene.blob().scene), view, kEffects,
                                           {.bytes = arguments.ram,
                                            .strip_rows = arguments.rows,
                                            .strip_columns = arguments.columns,
                                            .strip_buffers = arguments.buffers,
                                            .modes = kEffects.has(effect::bins) ? Modes::binned : Modes::streamed});
  if (!status) return bench::report(status);
  const std::uint32_t needed = plan.bytes() + plan.strip_pixel_bytes(view);
  if (needed < plan.bytes() || needed > kDrawn) {
    return bench::report({Error::arena_too_small, Purpose::none, needed, kDrawn});
  }
  bench::InstructionCounter counter;
  bench::print_configuration(arguments, plan, view);
  bench::print(", \"frames\": [");
  std::uint64_t total = 0;
  for (std::uint32_t frame = 0; frame < arguments.frames; ++frame) {
    const bench::FrameResult result = bench::run_frame(
        renderer, staged, view, plan, counter, [&] { return scene.place(frame, arguments.frames); },
        arguments.in_turns);
    if (!result.status) {
      bench::print("\n");
      return bench::report(result.status);
    }
    bench::print(frame == 0 ? "{\"frame\": " : ", {\"frame\": ");
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
  bench::print("}\n");
  return bench::kDone;
}

}  // namespace

int main() { return bench::run_scene("played_scene", run); }
