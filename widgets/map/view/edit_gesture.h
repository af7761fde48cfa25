#pragma once

#include "core/scenario/scenario.h"

#include <QString>

#include <functional>

namespace berg {

class ScenarioDocument;

/**
 * One change made with the mouse, from press to release: visible at once, one undo step when
 * finished, and without trace when cancelled. It edits the document continuously, so that plans
 * follow. If there is something to redo, which an edit would discard, it shows a preview instead
 * and edits at the end.
 */
class EditGesture
{
public:
    using Change = std::function<void(Scenario&)>;
    using Preview = std::function<void(const Scenario*)>; ///< null ends the preview

    /** Starts from the present scenario, to which `cancel` returns; `text` names the undo step. */
    EditGesture(ScenarioDocument& document, QString text, Preview preview);
    /** An unfinished gesture keeps what it has done to the document; a preview is lost. */
    ~EditGesture();
    EditGesture(const EditGesture&) = delete;
    EditGesture& operator=(const EditGesture&) = delete;

    /** Returns the scenario at the start of the gesture. */
    [[nodiscard]] const Scenario& start() const { return m_start; }
    /** Returns the scenario with the changes so far. */
    [[nodiscard]] const Scenario& now() const { return m_now; }

    /** Replaces the gesture's earlier changes by `change`, applied to the start. */
    void apply(const Change& change);
    /** Makes the change permanent as one undo step. */
    void finish();
    /** Undoes the change. */
    void cancel();

    /** Returns true during `apply`, `finish` and `cancel`: the gesture causes document changes. */
    [[nodiscard]] bool isApplying() const { return m_isApplying; }

private:
    void edit(const Scenario& scenario);
    void end();

    ScenarioDocument& m_document;
    QString m_text;
    Preview m_preview;
    Scenario m_start;
    Scenario m_now;
    bool m_isLive;
    bool m_isApplying = false;
    bool m_isOpen = true;
};

} // namespace berg
