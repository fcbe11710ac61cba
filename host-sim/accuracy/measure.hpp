// Measures one scene with many settings: errors compared with the truth, cost in time and memory.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accuracy/errors.hpp"
#include "accuracy/knobs.hpp"
#include "accuracy/truth.hpp"
#include "render/stage.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The request for a measurement.
struct AccuracyRequest {
  std::string scene;
  View view;  ///< its format is ignored: the settings have one
  std::optional<UpAxis> up{};
  std::uint32_t frames = 2;  ///< poses of a full rotation
  std::string target = "host";
  std::string firmware;  ///< folder of the boards' programs; empty: the folder where the build puts them
};

/// Returns the scene's name for plots and tables: for a file its name without folder and suffix.
std::string scene_name(const AccuracyRequest& request);

/// The cost of one picture, the mean of all poses.
struct Cost {
  double nanoseconds = 0;                         ///< on this machine, the minimum of several rounds; 0 on boards
  std::optional<std::uint64_t> instructions{};    ///< on the target; none on the host
  std::optional<double> least_fps{}, most_fps{};  ///< predicted for the board; none if it has too little RAM
  std::uint64_t ram_bytes = 0;                    ///< arena and one strip of pixels
  std::uint64_t scene_bytes = 0;                  ///< flash of the scene, as a baked blob
  std::optional<std::uint64_t> program_bytes{};   ///< flash of a program with only this pipeline; only for boards
};

/// The part of Cost that is known without measuring.
struct MemoryCost {
  std::uint64_t ram_bytes = 0, scene_bytes = 0;
};

struct AccuracyPoint {
  std::string scene;
  std::string target;
  Settings settings;
  std::string part;  ///< "one": differs from the default in one knob, or is measured with these points; "product"
  Errors errors;
  Cost cost;
  bool on_front = false;
};

/// Returns the value for the time axis: instructions if they are known, else nanoseconds.
double time_of(const AccuracyPoint& point);

/// Pictures of the first pose, for display.
struct AccuracyPictures {
  std::vector<std::array<float, 3>> drawn;
  std::vector<float> heat;
};

/// A scene with its poses and their truth. Measuring is safe from several threads at once.
class AccuracyScene {
 public:
  static Result<std::unique_ptr<AccuracyScene>> open(const AccuracyRequest& request);
  /// Returns the same scene with the times of another target. Both share all results that do not depend on the target.
  AccuracyScene on(std::string_view target) const;

  const AccuracyRequest& request() const { return request_; }
  /// Returns the effects that the scene needs with default settings.
  Effects effects() const;
  /// Returns the effects that drawing with these settings needs; flat shading needs fewer.
  Effects effects_with(const Settings& settings) const;
  std::vector<Knob> knobs() const;
  bool possible(const Settings& settings) const;

  Result<Errors> errors(const Settings& settings, AccuracyPictures* pictures = nullptr) const;
  Result<Cost> cost(const Settings& settings) const;
  Result<MemoryCost> memory(const Settings& settings) const;
  const std::vector<std::array<float, 3>>& true_picture() const;

  /// Two for each pose, slightly apart, with the scene's own settings; and the truth of each.
  std::span<const Staging> staged() const;
  std::span<const Truth> truths() const;

 private:
  /// The data that no target changes.
  struct Poses;
  AccuracyScene(AccuracyRequest request, std::shared_ptr<Poses> poses);
  const Staging& first() const;
  Result<Errors> find_errors(const Settings& settings, AccuracyPictures* pictures) const;

  AccuracyRequest request_;
  std::shared_ptr<Poses> poses_;
};

}  // namespace zstrip::sim
