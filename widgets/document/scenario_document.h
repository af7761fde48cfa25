#pragma once

#include "core/scenario/scenario.h"
#include "core/tracking/position_error.h"

#include <QMap>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QUndoStack;

namespace berg {

/** Returns the SHA-256 hash of a file's content. */
[[nodiscard]] QByteArray hashOf(const std::string& content);

/**
 * The scenario being edited. Only this class changes it, one undo step per gesture. Views read
 * `scenario()` after `scenarioChanged` and request changes by `edit`. GUI thread.
 */
class ScenarioDocument : public QObject
{
    Q_OBJECT

public:
    explicit ScenarioDocument(QObject* parent = nullptr);
    ~ScenarioDocument() override;

    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }
    /** Returns the findings of `validate` in the present scenario. */
    [[nodiscard]] const std::vector<Issue>& issues() const { return m_issues; }
    [[nodiscard]] QUndoStack* undoStack() const { return m_undoStack; }

    /** Returns the sensor of new icebergs: the user's last choice, whatever the scenario. */
    [[nodiscard]] SightingSource newIcebergSource() const { return m_newIcebergSource; }
    void setNewIcebergSource(SightingSource source);
    /** Returns an iceberg with the uncertainty of that sensor, without id and position. */
    [[nodiscard]] Iceberg newIceberg() const;

    /** Returns the path of the file, or an empty text if the scenario was never saved. */
    [[nodiscard]] QString filePath() const { return m_filePath; }
    /**
     * Returns the hash of the bytes read from or written to the file, empty if neither was done.
     */
    [[nodiscard]] const QByteArray& fileHash() const { return m_fileHash; }
    [[nodiscard]] bool isClean() const;

    /**
     * Applies `change` to a copy and makes it the scenario, with an undo step named `text`.
     * Successive edits with the same non-empty `gesture` form one step, which `endGesture` closes.
     * Returns whether the scenario changed: an edit without effect leaves the history alone, a
     * locked document emits `refused`, and a change that would make the scenario `unreadable` emits
     * `editRejected`, so that saved files can be opened.
     */
    bool edit(const QString& text, const std::function<void(Scenario&)>& change,
              const QString& gesture = {});
    void endGesture();
    /**
     * Applies a change that is not the user's, such as the place of a ship, without an undo step:
     * undo and redo keep the last change under each `key`. A locked document stays as it is.
     */
    void follow(const QString& key, const std::function<void(Scenario&)>& change);
    /** Forgets the change under `key`; the scenario stays as it is. */
    void stopFollowing(const QString& key) { m_followed.remove(key); }
    void undo();
    void redo();

    /** Locks the document in flight. Only another scenario can still replace it. */
    void setLocked(bool locked) { m_isLocked = locked; }
    [[nodiscard]] bool isLocked() const { return m_isLocked; }

    /** Replaces everything by a new, unsaved scenario and clears the history. */
    void reset(const Scenario& scenario);

    /** Replaces everything by recovered work, which counts as unsaved changes of `filePath`. */
    void restore(const Scenario& scenario, const QString& filePath);

    /** Opens a file. Throws `Error` as `loadScenario` and then changes nothing. */
    void open(const QString& path);
    /** Saves to a file. Throws `Error{FileUnwritable}`; then the document stays unsaved. */
    void save(const QString& path);

signals:
    void scenarioChanged();
    /**
     * Emitted before `scenarioChanged` when another scenario replaces this one (`reset`, `restore`
     * or `open`).
     */
    void replaced();
    void newIcebergSourceChanged(berg::SightingSource source);
    void filePathChanged(const QString& path);
    void cleanChanged(bool clean);
    /** Emitted when a change was requested while the document is locked. */
    void refused();
    /** Emitted when a change was rejected because the saved scenario could not be read again. */
    void editRejected(const berg::Issue& why);

private:
    friend class EditScenario;
    void begin(const Scenario& scenario, const QString& filePath, bool clean,
               const QByteArray& fileHash = {});
    void setScenario(const Scenario& scenario);
    [[nodiscard]] bool refuses();
    void stepTo(const Scenario& scenario);

    Scenario m_scenario;
    std::vector<Issue> m_issues;
    QUndoStack* m_undoStack;
    QMap<QString, std::function<void(Scenario&)>> m_followed;
    QString m_filePath;
    QByteArray m_fileHash;
    SightingSource m_newIcebergSource = SightingSource::Radar;
    bool m_isLocked = false;
    bool m_isStepping = false; ///< whether an undo or redo is being reported
    int m_gestureNumber = 0;   ///< distinguishes equal gestures that follow each other
};

} // namespace berg
