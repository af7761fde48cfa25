#pragma once

#include "core/study/drift_tracks.h"
#include "widgets/tasks/latest_task.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace berg {

/**
 * Predicts the drift of the icebergs (`driftTracks`) on its own thread at low priority, a moment
 * after the last change. Changes that do not affect it are ignored. GUI thread.
 */
class DriftTrackRunner : public QObject
{
    Q_OBJECT

public:
    using Tracks = std::shared_ptr<const std::vector<DriftTrack>>;

    explicit DriftTrackRunner(QObject* parent = nullptr);

    /** Requests the drift of the scenario's icebergs, with a point each `every_s` up to 48 h. */
    void setScenario(const Scenario& scenario, double every_s);
    /**
     * Requests the drift from an instant of a flight. The tracks so far are kept until the new ones
     * are known; of the requests made meanwhile only the newest counts.
     */
    void setInstant(const Scenario& scenario, DriftInstant instant, double every_s);
    /** Drops the tracks and what is being computed. */
    void clear();
    /** Returns the tracks; null until those of the scenario requested last are known. */
    [[nodiscard]] const Tracks& tracks() const { return m_tracks; }

signals:
    /** Emitted when `tracks` has changed. */
    void updated();

private:
    struct Request
    {
        Scenario scenario;                   ///< reduced to what the drift depends on
        std::optional<DriftInstant> instant; ///< nullopt means the start of the run
        double every_s = 0;
        bool operator==(const Request&) const = default;
    };
    void start();
    void drop();
    void setTracks(Tracks tracks);

    std::optional<Request> m_request;
    Tracks m_tracks;
    bool m_isRunning = false;
    bool m_isStale = false;             ///< whether `m_request` is newer than the request that runs
    QTimer m_pause;                     ///< restarted by each change
    LatestTask<Request, Tracks> m_task; ///< last member: its thread ends before the others
};

} // namespace berg
