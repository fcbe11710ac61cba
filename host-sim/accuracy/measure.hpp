// One scene measured with many settings: errors against the truth, cost in time and memory.
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

/// What is measured.
struct AccuracyRequest {
  std::string scene;
  View view;  ///< its format is the settings'
  std::optional<UpAxis> up{};
  std::uint32_t frames = 2;  ///< poses of a turn
  std::string target = "host";
  std::string firmware;  ///< folder of the boards' programs; empty: where the build puts them
};

/// The scene as plots and tables call it: of a file its name without folder and suffix.
std::string scene_name(const AccuracyRequest& request);

/// Of one picture, means of the poses.
struct Cost {
  double nanoseconds = 0;                         ///< on this machine, the least of some rounds; 0 on boards
  std::optional<std::uint64_t> instructions{};    ///< of the target; of the host none
  std::optional<double> least_fps{}, most_fps{};  ///< predicted of the board; none where it has too little RAM
  std::uint64_t ram_bytes = 0;                    ///< arena and one strip of pixels
  std::uint64_t scene_bytes = 0;                  ///< flash of the scene, as a baked blob
  std::optional<std::uint64_t> program_bytes{};   ///< flash of a program with this pipeline alone, boards only
};

/// The part of Cost that needs no measuring.
struct MemoryCost {
  std::uint64_t ram_bytes = 0, scene_bytes = 0;
};

struct AccuracyPoint {
  std::string scene;
  std::string target;
  Settings settings;
  std::string part;  ///< "one": differs from the default in one knob, or is measured beside those; "product"
  Errors errors;
  Cost cost;
  bool on_front = false;
};

/// What the time axis shows: instructions where there are any, else nanoseconds.
double time_of(const AccuracyPoint& point);

/// Pictures of the first pose, for people.
struct AccuracyPictures {
  std::vector<std::array<float, 3>> drawn;
  std::vector<float> heat;
};

/// A scene with its poses and their truth. Measuring is safe from several threads at once.
class AccuracyScene {
 public:
  static Result<std::unique_ptr<AccuracyScene>> open(const AccuracyRequest& request);
  /// The same scene where time is that of another target. What does not depend on it is found once for both.
  AccuracyScene on(std::string_view target) const;

  const AccuracyRequest& request() const { return request_; }
  /// What the scene calls for, at its default settings.
  Effects effects() const;
  /// What drawing with these settings needs; flat shading needs less.
  Effects effects_with(const Settings& settings) const;
  std::vector<Knob> knobs() const;
  bool possible(const Settings& settings) const;

  Result<Errors> errors(const Settings& settings, AccuracyPictures* pictures = nullptr) const;
  Result<Cost> cost(const Settings& settings) const;
  Result<MemoryCost> memory(const Settings& settings) const;
  const std::vector<std::array<float, 3>>& true_picture() const;

  /// Two a pose, a little apart, as the scene has them; and the truth of each.
  std::span<const Staging> staged() const;
  std::span<const Truth> truths() const;

 private:
  /// What no target changes.
  struct Poses;
  AccuracyScene(AccuracyRequest request, std::shared_ptr<Poses> poses);
  const Staging& first() const;
  Result<Errors> find_errors(const Settings& settings, AccuracyPictures* pictures) const;

  AccuracyRequest request_;
  std::shared_ptr<Poses> poses_;
};

}  // namespace zstrip::sim
