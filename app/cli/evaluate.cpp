#include "app/cli/command.h"

#include "hexoderm/base/limits.h"
#include "hexoderm/solve/checks/evaluation.h"

#include <iostream>
#include <optional>

namespace hexoderm::cli {
namespace {

struct EvaluateOptions {
  std::string input;
  std::string fit;
  std::optional<double> true_radius_m;
  std::string loop;
  std::string against;
};

LinkEnd parseEnd(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 2) throw InvalidArgument("--loop: expected CELL:PORT,CELL:PORT, found \"" + text + "\"");
  return {CellId(parseUnsigned(parts[0], "--loop")), PortNumber(parseUnsigned(parts[1], "--loop"))};
}

Json vectorInMm(const Eigen::Vector3d& v) { return listOf(v / kMillimetre); }

std::string inMm(const Eigen::Vector3d& v) { return "[" + inWords(v / kMillimetre, 2, "; ") + "] mm"; }

class Evaluation {
 public:
  Evaluation(const Reconstruction& calibration, bool json)
      : calibration_(calibration), json_(json), out_(json ? nullptr : std::cout.rdbuf()) {
    out_ << sizeText(calibration) << '\n';
    if (calibration.patches.size() > 1) {
      out_ << "How the patches lie to each other is not known: every figure is one of a patch by itself.\n";
    }
    result_["patches"] = calibration.patches.size();
  }

  void fit(SurfaceKind kind, std::optional<double> true_radius_m) {
    auto fits = Json::array();
    std::size_t fitted = 0;
    for (const PatchReconstruction& patch : calibration_.patches) {
      SurfaceEvaluation surface;
      try {
        surface = checkSurface(patch, kind, true_radius_m);
      } catch (const InvalidArgument& error) {
        // A cell that fell off does not stand in the way of the others.
        if (&patch == &calibration_.patches.back() && fitted == 0) throw;
        fits.push_back({{"patch", patch.id.value()}, {"surface", surfaceKindName(kind)}, {"why_not", error.what()}});
        out_ << "Patch " << patch.id << ": " << error.what() << '\n';
        continue;
      }
      ++fitted;
      fits.push_back(toJson(surface));
      out_ << "Patch " << patch.id << ", " << surfaceKindName(kind) << " through " << surface.cells.size()
           << " cell centres: ";
      if (surface.radius_m) out_ << "radius " << millimetres(*surface.radius_m) << ", ";
      out_ << "distances " << millimetres(surface.rms_m, 3) << " rms\n";
      if (surface.better) {
        out_ << "  It is not this surface: the cells face " << degrees(surface.tilt_rms_rad, 1)
             << " rms away from it, and " << degrees(surface.better->tilt_rms_rad, 1) << " from a "
             << surfaceKindName(surface.better->kind) << '\n';
      }
      out_ << "  point " << inMm(surface.point);
      if (kind != SurfaceKind::Sphere) {
        out_ << (kind == SurfaceKind::Plane ? ", normal [" : ", axis [") << inWords(surface.axis, 4, "; ") << "]";
      }
      if (surface.half_angle_rad) out_ << ", half angle " << degrees(*surface.half_angle_rad, 2);
      out_ << '\n';
      if (surface.delta_m) {
        out_ << "  Delta, eq. (20): " << millimetres(*surface.delta_m, 3)
             << "; eps, eq. (21): " << millimetres(*surface.epsilon_m, 3) << '\n';
      }
    }
    result_["fits"] = fits;
  }

  void loop(LinkEnd first, LinkEnd second) {
    const LoopEvaluation loop = evaluateLoop(calibration_, first, second);
    result_["loop"] = {{"gap_mm", vectorInMm(loop.gap_m)},
                       {"length_mm", toMillimetres(loop.length_m)},
                       {"loop_length_mm", toMillimetres(loop.loop_length_m)},
                       {"percent", loop.percent}};
    out_ << "Loop gap between cell " << first.cell << " port " << first.port << " and cell " << second.cell << " port "
         << second.port << ": " << inMm(loop.gap_m) << ", " << millimetres(loop.length_m) << " long, "
         << formatFixed(loop.percent, 2) << " % of the loop's " << millimetres(loop.loop_length_m) << '\n';
  }

  void against(const OpenedFile& other, const std::string& path) {
    std::vector<Comparison> comparisons;
    if (const auto* session = std::get_if<Session>(&other)) {
      if (!session->truth()) throw BadInput(path + ": this session holds no truth to compare with");
      comparisons = compareToTruth(calibration_, *session->truth());
    } else {
      comparisons = compareToReconstruction(calibration_, *std::get<std::shared_ptr<const Reconstruction>>(other));
    }
    if (comparisons.empty()) throw BadInput(path + ": has no cell in common with the calibration");
    result_["against"] = arrayOf(comparisons, [](const Comparison& comparison) { return toJson(comparison); });
    for (const Comparison& comparison : comparisons) print(comparison);
  }

  void findingsAndVerdict() {
    result_["findings"] = cli::toJson(calibration_.findings);
    result_["verdict"] = cli::toJson(calibration_.assessment);
    if (json_) {
      printJson(result_);
    } else {
      printVerdict(calibration_.assessment);
    }
    if (!json_ && !out_) std::cout.setstate(std::ios::badbit);  // whose state the end of the program looks at
  }

 private:
  static Json toJson(const SurfaceEvaluation& surface) {
    Json json;
    json["patch"] = surface.patch.value();
    json["surface"] = surfaceKindName(surface.kind);
    json["point_mm"] = vectorInMm(surface.point);
    if (surface.kind != SurfaceKind::Sphere) json["axis"] = listOf(surface.axis);
    if (surface.radius_m) json["radius_mm"] = toMillimetres(*surface.radius_m);
    if (surface.half_angle_rad) json["half_angle_deg"] = toDegrees(*surface.half_angle_rad);
    json["rms_mm"] = toMillimetres(surface.rms_m);
    json["tilt_rms_deg"] = toDegrees(surface.tilt_rms_rad);
    if (surface.better) json["more_probable"] = surfaceKindName(surface.better->kind);
    if (surface.delta_m) json["delta_mm"] = toMillimetres(*surface.delta_m);
    if (surface.epsilon_m) json["epsilon_mm"] = toMillimetres(*surface.epsilon_m);
    json["cells"] = Json::array();
    for (std::size_t k = 0; k < surface.cells.size(); ++k) {
      json["cells"].push_back(
          {{"id", surface.cells[k].value()}, {"distance_mm", toMillimetres(surface.distance_m[k])}});
    }
    return json;
  }

  static Json toJson(const Comparison& comparison) {
    const auto cell_json = [](const CellDifference& cell) {
      Json json = {{"id", cell.cell.value()},
                   {"position_mm", vectorInMm(cell.position_m)},
                   {"orientation_deg", toDegrees(cell.orientation_rad)}};
      if (cell.sigma_t_m) json["sigma_t_mm"] = toMillimetres(*cell.sigma_t_m);
      if (cell.sigma_r_rad) json["sigma_r_deg"] = toDegrees(*cell.sigma_r_rad);
      return json;
    };
    return {{"patch", comparison.patch.value()},
            {"position_rms_mm", toMillimetres(comparison.position_rms_m)},
            {"orientation_rms_deg", toDegrees(comparison.orientation_rms_rad)},
            {"cells", arrayOf(comparison.cells, cell_json)}};
  }

  void print(const Comparison& comparison) {
    if (comparison.cells.size() == 1) {
      out_ << "Patch " << comparison.patch << ": cell " << comparison.cells.front().cell
           << " alone, which fits wherever it is: nothing to compare\n";
      return;
    }
    out_ << "Patch " << comparison.patch << ", after alignment: position " << millimetres(comparison.position_rms_m, 3)
         << " rms, orientation " << degrees(comparison.orientation_rms_rad, 3) << " rms\n";
    out_ << "  cell   position  (stated)   orientation  (stated)\n";
    for (const CellDifference& cell : comparison.cells) {
      const auto stated = [](std::optional<double> sigma, auto format) {
        return sigma ? "(" + format(*sigma, 2) + ")" : std::string("(-)");
      };
      out_ << "  " << cell.cell << "   " << millimetres(cell.position_m.norm()) << " "
           << stated(cell.sigma_t_m, millimetres) << "   " << degrees(cell.orientation_rad) << " "
           << stated(cell.sigma_r_rad, degrees) << '\n';
    }
  }

  const Reconstruction& calibration_;
  bool json_;
  std::ostream out_;  ///< with --json nowhere
  Json result_;
};

int run(const EvaluateOptions& options, const Common& common) {
  if (options.true_radius_m && options.fit.empty())
    throw InvalidArgument("--true-radius: needs --fit cylinder or --fit sphere");
  const auto calibration = openCalibration(options.input);
  Evaluation evaluation(*calibration, common.json);
  if (!options.fit.empty()) {
    evaluation.fit(surfaceKindFromName(options.fit), options.true_radius_m);
  }
  if (!options.loop.empty()) {
    const std::vector<std::string> ends = split(options.loop, ',');
    if (ends.size() != 2) throw InvalidArgument("--loop: expected CELL:PORT,CELL:PORT, found \"" + options.loop + "\"");
    evaluation.loop(parseEnd(ends[0]), parseEnd(ends[1]));
  }
  if (!options.against.empty()) evaluation.against(openInput(options.against), options.against);
  evaluation.findingsAndVerdict();
  return kDone;
}

}  // namespace

void addEvaluate(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<EvaluateOptions>(
      app, common, "evaluate", "Surface fits, loop closure, comparison with a truth or a calibration",
      "Example:\n  hexoderm-cli evaluate arm.calibration.json --fit cylinder --true-radius 0.0501", run);
  addInput(command, "calibration", options.input, "Calibration (*.calibration.json, or TUM XML)")->required();
  command.add_option("--fit", options.fit, "plane, sphere, cylinder or cone through the cell centres");
  takeNumbersAbove(
      command.add_option("--true-radius", options.true_radius_m, "Known radius in metres: gives eqs. (20), (21)"), 0,
      kMaxLength_m);
  command.add_option("--loop", options.loop, "Gap between two free ports: CELL:PORT,CELL:PORT");
  addInput(command, "--against", options.against, "Calibration, or session with truth, to compare with");
}

}  // namespace hexoderm::cli
