#include "core/io/results/result_json.h"

#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "core/io/results/result_parts.h"
#include "core/io/results/weather_result.h"
#include "core/plan/policy/policy.h"

#include <algorithm>

namespace berg {

namespace {

using Json = ResultJson;

constexpr std::array<Named<Severity>, 3> kSeverityNames{{
    {Severity::Error, "error"},
    {Severity::Warning, "warning"},
    {Severity::Hint, "hint"},
}};

constexpr std::array<Named<ErrorCode>, 11> kErrorNames{{
    {ErrorCode::FileNotFound, "file-not-found"},
    {ErrorCode::FileUnreadable, "file-unreadable"},
    {ErrorCode::FileUnwritable, "file-unwritable"},
    {ErrorCode::FileTooLarge, "file-too-large"},
    {ErrorCode::SyntaxError, "syntax-error"},
    {ErrorCode::WrongFormat, "wrong-format"},
    {ErrorCode::UnsupportedVersion, "unsupported-version"},
    {ErrorCode::InvalidInput, "invalid-input"},
    {ErrorCode::Unsupported, "unsupported"},
    {ErrorCode::SolverFailed, "solver-failed"},
    {ErrorCode::ReplayMismatch, "replay-mismatch"},
}};

void addFindings(Json& list, const FileFindings& file)
{
    for (const Issue& issue : file.issues)
        list.push_back({{"file", file.file},
                        {"severity", nameOf(kSeverityNames, issue.severity)},
                        {"field", issue.field},
                        {"message", issue.message()}});
}

std::optional<PaperTime> paperTime(int icebergs)
{
    for (const PaperTime& time : paperTable2())
        if (time.icebergs == icebergs)
            return time;
    return std::nullopt;
}

std::optional<std::string> formulationOf(const BenchmarkSolver& solver)
{
    if (solver.backend != Backend::Cbc)
        return std::nullopt;
    return nameOf(kFormulationNames, solver.formulation);
}

Json settingJson(const StudySetting& setting)
{
    return {{"policy", nameOf(kPolicyNames, setting.policy)}, {"tau", orNull(setting.tau)}};
}

Json percentJson(const MeanInterval& relative)
{
    return {{"mean_percent", 100 * relative.mean},
            {"low_percent", 100 * relative.low},
            {"high_percent", 100 * relative.high}};
}

Json settingJson(const SettingSummary& row, const PairedDifference& against)
{
    Json json = settingJson(row.setting);
    json["n"] = row.zeta_m2s.n;
    json["mean_m2s"] = row.zeta_m2s.mean;
    json["standard_error_m2s"] = row.zeta_m2s.standardError;
    json["median_m2s"] = row.zeta_m2s.median;
    json["quartile1_m2s"] = row.zeta_m2s.quartile1;
    json["quartile3_m2s"] = row.zeta_m2s.quartile3;
    json["decile1_m2s"] = row.zeta_m2s.decile1;
    json["decile9_m2s"] = row.zeta_m2s.decile9;
    json["stuck_share"] = row.stuckShare;
    json["mean_visits"] = row.meanVisits;
    json["difference"] = percentJson(against.relative);
    json["lower_share"] = against.lowerShare;
    json["worst_percent"] = 100 * against.worst;
    return json;
}

Json bestTauJson(const BestTau& best)
{
    return {{"decile1", best.tau.decile1},
            {"median", best.tau.median},
            {"decile9", best.tau.decile9},
            {"mean_m2s", best.zeta_m2s.mean},
            {"difference", percentJson(best.relative)}};
}

} // namespace

std::vector<UavFigures> uavFigures(const Mission& mission)
{
    std::vector<UavFigures> figures;
    for (int i = 0; i < mission.simulation().uavCount(); ++i) {
        figures.push_back({.id = mission.scenario().uavs[static_cast<std::size_t>(i)].id,
                           .visits = mission.visits(i),
                           .flown_m = mission.simulation().uav(i).flown_m});
    }
    return figures;
}

std::vector<std::pair<std::string, int>> worldEvents(const Mission& mission)
{
    std::vector<std::pair<std::string, int>> counts;
    for (const EventKind kind :
         {EventKind::Lost, EventKind::Found, EventKind::GivenUp, EventKind::Left, EventKind::Alarm,
          EventKind::Landed, EventKind::TookOff, EventKind::LateHome, EventKind::LeftFence,
          EventKind::PlannerFailed}) {
        const auto count =
            std::count_if(mission.events().begin(), mission.events().end(),
                          [kind](const MissionEvent& event) { return event.kind == kind; });
        if (count > 0)
            counts.emplace_back(nameOf(kEventNames, kind), static_cast<int>(count));
    }
    return counts;
}

std::string simulateJson(const Mission& mission, std::optional<double> lowerBound_m2s,
                         double elapsed_s, const std::optional<WeatherVerdict>& weather)
{
    const Metrics metrics = mission.metrics();
    Json json{{"zeta_m2s", metrics.zeta_m2s},
              {"visits", metrics.visits},
              {"replans", metrics.replans},
              {"flown_m", metrics.flown_m},
              {"lower_bound_m2s", orNull(lowerBound_m2s)},
              {"seconds", elapsed_s},
              {"uavs", Json::array()},
              {"closest_m", orNull(mission.simulation().fleet().closest_m())}};
    for (const UavFigures& uav : uavFigures(mission))
        json["uavs"].push_back({{"id", uav.id}, {"visits", uav.visits}, {"flown_m", uav.flown_m}});
    for (const auto& [name, count] : worldEvents(mission))
        json["events"][name] = count;
    if (weather) {
        std::vector<std::string> ids;
        for (const Uav& uav : mission.scenario().uavs)
            ids.push_back(uav.id);
        json["weather"] = weatherTree(ids, *weather);
    }
    return resultText(json);
}

std::string sweepJson(const Study& study, const StudySummary& summary,
                      const std::optional<double>& elapsed_s)
{
    Json rows = Json::array();
    for (std::size_t i = 0; i < summary.settings.size(); ++i)
        rows.push_back(settingJson(summary.settings[i], summary.differences.at(i)));
    Json json{{"rows", rows}};
    if (summary.reference < summary.settings.size())
        json["reference"] = settingJson(summary.settings[summary.reference].setting);
    if (summary.bestTau)
        json["best_tau"] = bestTauJson(*summary.bestTau);
    json["missions"] = missionCount(study.spec);
    json["flown"] = flownCount(study);
    json["cases"] = summary.cases.size();
    if (elapsed_s)
        json["seconds"] = *elapsed_s;
    return resultText(json);
}

std::string benchmarkJson(const std::vector<BenchmarkRow>& rows)
{
    Json list = Json::array();
    for (const BenchmarkRow& row : rows) {
        const bool timed = row.seconds.n > 0;
        Json one{{"icebergs", row.icebergs},
                 {"backend", nameOf(kBackendNames, row.solver.backend)},
                 {"formulation", orNull(formulationOf(row.solver))},
                 {"instances", row.instances},
                 {"proven", row.proven},
                 {"cut", row.cut},
                 {"average_s", timed ? Json(row.seconds.mean) : Json(nullptr)},
                 {"median_s", timed ? Json(row.seconds.median) : Json(nullptr)},
                 {"worst_s", timed ? Json(row.worst_s) : Json(nullptr)},
                 {"worst_gap", orNull(row.worstGap)},
                 {"mean_objective", timed ? Json(row.meanObjective) : Json(nullptr)},
                 {"work", timed ? Json(row.work) : Json(nullptr)}};
        if (const auto paper = paperTime(row.icebergs)) {
            one["paper_average_s"] = paper->average_s;
            one["paper_worst_s"] = paper->worst_s;
            if (timed && row.seconds.mean > 0)
                one["speed_up"] = paper->average_s / row.seconds.mean;
            if (timed && row.worst_s > 0)
                one["worst_speed_up"] = paper->worst_s / row.worst_s;
        }
        if (!row.note.empty())
            one["note"] = row.note;
        list.push_back(std::move(one));
    }
    return resultText(Json{{"rows", list}});
}

std::string findingsJson(const std::vector<FileFindings>& files)
{
    Json list = Json::array();
    for (const FileFindings& file : files) {
        addFindings(list, file);
        if (!hasErrors(file.issues))
            list.push_back({{"file", file.file}, {"severity", "valid"}});
    }
    return resultText(list);
}

std::string failureJson(std::string_view kind, const FileFindings& found)
{
    Json list = Json::array();
    addFindings(list, found);
    return resultText(Json{{"error", {{"kind", kind}, {"findings", list}}}});
}

std::string failureJson(const Error& error)
{
    return failureJson(nameOf(kErrorNames, error.code()),
                       {.file = error.subject(), .issues = error.issues()});
}

std::string sweepCsv(const StudySummary& summary)
{
    std::string csv = "policy,tau,n,mean_m2s,standard_error_m2s,median_m2s,quartile1_m2s,"
                      "quartile3_m2s,decile1_m2s,decile9_m2s,stuck_share,mean_visits,"
                      "difference_percent,difference_low_percent,difference_high_percent,"
                      "lower_share,worst_percent\n";
    for (std::size_t i = 0; i < summary.settings.size(); ++i) {
        const SettingSummary& row = summary.settings[i];
        const Summary& s = row.zeta_m2s;
        const PairedDifference& difference = summary.differences.at(i);
        const MeanInterval& relative = difference.relative;
        const std::optional<double>& tau = row.setting.tau;
        csv += nameOf(kPolicyNames, row.setting.policy) + ',' + (tau ? numberText(*tau) : "") +
               ',' + std::to_string(s.n);
        for (const double value :
             {s.mean, s.standardError, s.median, s.quartile1, s.quartile3, s.decile1, s.decile9,
              row.stuckShare, row.meanVisits, 100 * relative.mean, 100 * relative.low,
              100 * relative.high, difference.lowerShare, 100 * difference.worst})
            csv += ',' + numberText(value);
        csv += '\n';
    }
    return csv;
}

std::string benchmarkCsv(const std::vector<BenchmarkRow>& rows)
{
    std::string csv = "icebergs,backend,formulation,instances,proven,cut,average_s,median_s,"
                      "worst_s,worst_gap,mean_objective,work,paper_average_s,paper_worst_s,note\n";
    for (const BenchmarkRow& row : rows) {
        csv += std::to_string(row.icebergs) + ',' + nameOf(kBackendNames, row.solver.backend) +
               ',' + formulationOf(row.solver).value_or("") + ',' + std::to_string(row.instances) +
               ',' + std::to_string(row.proven) + ',' + std::to_string(row.cut);
        const bool timed = row.seconds.n > 0;
        for (const double value : {row.seconds.mean, row.seconds.median, row.worst_s})
            csv += ',' + (timed ? numberText(value) : std::string());
        csv += ',' + (row.worstGap ? numberText(*row.worstGap) : std::string());
        csv += ',' + (timed ? numberText(row.meanObjective) : std::string());
        csv += ',' + (timed ? std::to_string(row.work) : std::string());
        const auto paper = paperTime(row.icebergs);
        csv += ',' + (paper ? numberText(paper->average_s) : std::string());
        csv += ',' + (paper ? numberText(paper->worst_s) : std::string());
        csv += ',' + csvField(row.note) + '\n';
    }
    return csv;
}

} // namespace berg
