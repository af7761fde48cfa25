#include "widgets/forecast/bound_runner.h"

#include "core/checks/validate.h"

#include <algorithm>
#include <optional>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 1000; // plan, curve and forecasts come first
constexpr int kBetweenReports_ms = 200;

/** Returns the part of a scenario that its bound depends on: motion alone, without names. */
Scenario boundedPart(const ScenarioPhysics& motion)
{
    Scenario part;
    static_cast<ScenarioPhysics&>(part) = motion;
    for (Uav& uav : part.uavs) {
        uav.name.clear();
        uav.extraJson.clear();
    }
    for (Iceberg& iceberg : part.icebergs) // its id stays: the noise is drawn by it
        for (std::string* text :
             {&iceberg.name, &iceberg.uav, &iceberg.trackExtraJson, &iceberg.extraJson})
            text->clear();
    return part;
}

/** Returns the bound if it is of use: zeta is never below zero. */
std::optional<double> usefulBound_m2s(double zeta_m2s)
{
    return zeta_m2s > 0 ? std::optional(zeta_m2s) : std::nullopt;
}

/** Returns the work of the task, which reports the bound of a scenario as it grows. */
auto boundWork(std::int64_t workLimit)
{
    return [workLimit](const Scenario& scenario, const std::stop_token& stop,
                       const std::function<void(KnownBound)>& deliver) {
        ReportPace pace(kBetweenReports_ms);
        const auto report = [&](const BoundProgress& progress) {
            if (pace.isDue())
                deliver({.zeta_m2s = usefulBound_m2s(progress.zeta_m2s), .share = progress.share});
        };
        const auto bound = std::make_shared<const ZetaBound>(
            zetaLowerBound(scenario, {.workLimit = workLimit, .stop = stop, .onProgress = report}));
        deliver({.zeta_m2s = usefulBound_m2s(bound->zeta_m2s), .share = 1, .whole = bound});
    };
}

} // namespace

BoundRunner::BoundRunner(QObject* parent, std::int64_t workLimit)
    : QObject(parent)
    , m_task(u"bound"_s,
             {.work = boundWork(workLimit),
              .deliver =
                  [this](KnownBound known) {
                      // Every bound found is valid, so the largest one counts.
                      known.zeta_m2s = std::max(known.zeta_m2s, m_known.zeta_m2s);
                      m_known = std::move(known);
                      m_complete = m_known.whole != nullptr;
                      emit updated();
                  },
              .end =
                  [this](const std::optional<WorkFailure>& failure) {
                      if (!failure)
                          return;
                      m_known = {}; // usually out of memory
                      m_complete = true;
                      emit updated();
                  }},
             WorkPriority::Low)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &BoundRunner::start);
}

void BoundRunner::setScenario(const Scenario& scenario)
{
    Scenario part = boundedPart(scenario);
    if (m_scenario == part)
        return;
    m_scenario = std::move(part);
    m_task.drop();
    m_known = {};
    m_complete = false;
    m_pause.start();
    emit updated();
}

void BoundRunner::start()
{
    if (hasErrors(validate(*m_scenario))) { // the window reports them elsewhere
        m_complete = true;
        emit updated();
        return;
    }
    m_task.start(*m_scenario);
}

} // namespace berg
