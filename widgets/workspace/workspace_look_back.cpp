// Looking back at the flight: showing instants, playing the record, and continuing from an instant.

#include "widgets/workspace/workspace.h"

#include <algorithm>
#include <utility>

namespace berg {

void Workspace::playBack()
{
    const double time_s =
        *m_lookedAt_s + m_rate.value() * static_cast<double>(m_playClock.restart()) / 1000;
    if (time_s < m_record.now.time_s) {
        m_lookedAt_s = time_s;
        m_runner.requestInstant(time_s);
        return;
    }
    seekLatest(); // at the end of the record the flight continues
    if (m_record.now.phase == RunPhase::Paused)
        m_runner.fly(m_rate);
}

void Workspace::seek(double time_s)
{
    if (!inFlight())
        return;
    m_playBack.stop();
    if (m_record.now.phase == RunPhase::Flying) {
        m_runner.pause();
    } else if (time_s >= m_record.now.time_s) {
        seekLatest();
        return;
    }
    m_lookedAt_s = std::clamp(time_s, 0.0, m_record.now.time_s);
    m_runner.requestInstant(*m_lookedAt_s);
}

void Workspace::seekLatest()
{
    m_playBack.stop();
    m_lookedAt_s.reset();
    if (m_record.instant) {
        m_record.instant.reset();
        updateCurve();
        emit flightChanged();
    }
}

void Workspace::acceptInstant()
{
    std::optional<MissionSnapshot> instant = m_runner.acceptInstant();
    if (!instant || !m_lookedAt_s)
        return;
    m_record.instant = std::move(instant);
    updateCurve();
    emit flightChanged();
}

void Workspace::stepBack()
{
    seek(m_lookedAt_s.value_or(m_record.now.time_s) - 1);
}

void Workspace::stepTicks(int ticks)
{
    const double dt_s = m_document.scenario().dt_s;
    if (m_lookedAt_s || ticks < 0) {
        seek(m_lookedAt_s.value_or(m_record.now.time_s) + ticks * dt_s);
        return;
    }
    prepareTakeOff();
    flyTau();
    m_runner.stepBy(ticks * dt_s);
}

void Workspace::stepToEvent(int direction)
{
    const std::vector<MissionEvent>& events = m_record.history.events;
    const double now_s = m_lookedAt_s.value_or(m_record.now.time_s);
    const double half_s = m_document.scenario().dt_s / 2;
    if (direction > 0) {
        const auto next = std::find_if(events.begin(), events.end(), [&](const MissionEvent& e) {
            return e.time_s > now_s + half_s;
        });
        if (next == events.end())
            seekLatest();
        else
            seek(next->time_s);
        return;
    }
    const auto before = std::find_if(events.rbegin(), events.rend(), [&](const MissionEvent& e) {
        return e.time_s < now_s - half_s;
    });
    if (before != events.rend())
        seek(before->time_s);
}

void Workspace::continueFromHere()
{
    if (!m_lookedAt_s)
        return;
    goBackTo({.time_s = *m_lookedAt_s, .seenUntil_s = m_record.now.time_s});
}

void Workspace::goBackTo(const ContinueRequest& request)
{
    if (request.time_s < m_record.now.time_s)
        m_runs.add(m_record); // the discarded flight can still be compared
    setDiscarded(presentFlight());
    m_runner.continueFrom(request);
    seekLatest();
}

std::optional<LastChange> Workspace::undoableChange() const
{
    return mayIntervene() ? m_record.now.lastChange : std::nullopt;
}

void Workspace::undoChange()
{
    const std::optional<LastChange> change = undoableChange();
    if (!change)
        return;
    m_tauWanted.reset();
    goBackTo({.time_s = change->first.time_s,
              .seenUntil_s = m_record.now.time_s,
              .interventions = change->before});
}

bool Workspace::refuseIntervention()
{
    if (mayIntervene())
        return false;
    emit refused(m_lookedAt_s ? tr("You are viewing an earlier instant. To change this, continue "
                                   "from here or go back to the latest.")
                              : runEndedText());
    return true;
}

} // namespace berg
