#pragma once

#include "core/scenario/scenario.h"
#include "core/tracking/position_error.h"

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QUndoStack;

namespace berg {

/** SHA-256 of the bytes of a file. */
[[nodiscard]] QByteArray hashOf(const std::string& content);

/**
 * The scenario being edited: the only place that changes it, one undo step per gesture. Views read
 * `scenario()` after `scenarioChanged` and ask for changes with `edit`. GUI thread.
 */
class ScenarioDocument : public QObject
{
    Q_OBJECT

public:
    explicit ScenarioDocument(QObject* parent = nullptr);
    ~ScenarioDocument() override;

    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }
    /** Findings of `validate` about the present scenario. */
    [[nodiscard]] const std::vector<Issue>& issues() const { return m_issues; }
    [[nodiscard]] QUndoStack* undoStack() const { return m_undoStack; }

    /** What new icebergs are seen by: the last choice of the user, whatever the scenario. */
    [[nodiscard]] SightingSource newIcebergSource() const { return m_newIcebergSource; }
    void setNewIcebergSource(SightingSource source);
    /** Without id and place, as uncertain as that source leaves it. */
    [[nodiscard]] Iceberg newIceberg() const;

    /** Empty: never saved. */
    [[nodiscard]] QString filePath() const { return m_filePath; }
    /** Of the bytes read from the file or written to it; empty: neither was done. */
    [[nodiscard]] const QByteArray& fileHash() const { return m_fileHash; }
    [[nodiscard]] bool isClean() const;

    /**
     * Applies `change` to a copy and makes it the scenario, undoable under `text`. Edits with the
     * same `gesture` (not empty), one directly after the other, are one step; `endGesture` closes
     * it. A change that changes nothing leaves the history alone. Returns whether it changed; while
     * the document is locked nothing does, and `refused` tells. Nor is a change made that would
     * make the scenario `unreadable`: what is saved can be opened.
     */
    bool edit(const QString& text, const std::function<void(Scenario&)>& change,
              const QString& gesture = {});
    void endGesture();
    void undo();
    void redo();

    /** In flight nothing is edited; another scenario altogether can still take its place. */
    void setLocked(bool locked) { m_isLocked = locked; }
    [[nodiscard]] bool isLocked() const { return m_isLocked; }

    /** Replaces everything and forgets the history: a new, unsaved scenario. */
    void reset(const Scenario& scenario);

    /** Unsaved work of a program that ended: as `reset`, but with changes that are in no file. */
    void restore(const Scenario& scenario, const QString& filePath);

    /** Throws `Error` of `loadScenario`; then nothing has changed. */
    void open(const QString& path);
    /** Throws `Error{FileUnwritable}`; then the document is as dirty as before. */
    void save(const QString& path);

signals:
    void scenarioChanged();
    /** Another scenario altogether: `reset` or `open`. Comes before `scenarioChanged`. */
    void replaced();
    void newIcebergSourceChanged(berg::SightingSource source);
    void filePathChanged(const QString& path);
    void cleanChanged(bool clean);
    /** A change was asked for while the document is locked. */
    void refused();
    /** A change was not made, with which the scenario could not be read again. */
    void impossible(const berg::Issue& why);

private:
    friend class EditScenario;
    void begin(const Scenario& scenario, const QString& filePath, bool clean,
               const QByteArray& fileHash = {});
    void setScenario(const Scenario& scenario);
    [[nodiscard]] bool refuses();

    Scenario m_scenario;
    std::vector<Issue> m_issues;
    QUndoStack* m_undoStack;
    QString m_filePath;
    QByteArray m_fileHash;
    SightingSource m_newIcebergSource = SightingSource::Radar;
    bool m_isLocked = false;
    bool m_isStepping = false; ///< an undo or redo is told of
    int m_gestureNumber = 0;   ///< distinguishes equal gestures that follow each other
};

} // namespace berg
