#pragma once

#include "core/scenario/scenario.h"

#include <QString>

#include <functional>

namespace berg {

class ScenarioDocument;

/**
 * One change made with the mouse, from press to release: seen while it is made, one undo step when
 * it is finished, no trace when it is taken back. Edits the document all the while, so that plans
 * follow; only when there is something to redo, which an edit would forget, it shows a preview and
 * edits at the end.
 */
class EditGesture
{
public:
    using Change = std::function<void(Scenario&)>;
    using Preview = std::function<void(const Scenario*)>; ///< null: no preview any more

    /** The scenario of now is what the gesture starts from and what `cancel` returns to. */
    EditGesture(ScenarioDocument& document, QString text, Preview preview);
    /** A gesture that was not finished stays as far as it got. */
    ~EditGesture();
    EditGesture(const EditGesture&) = delete;
    EditGesture& operator=(const EditGesture&) = delete;

    [[nodiscard]] const Scenario& start() const { return m_start; }
    /** As far as the gesture got. */
    [[nodiscard]] const Scenario& now() const { return m_now; }

    /** Puts `change` of the start in place of what the gesture did before. */
    void apply(const Change& change);
    void finish();
    void cancel();

    /** True inside `apply`, `finish` and `cancel`: changes of the document then come from here. */
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
