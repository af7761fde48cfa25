#include "widgets/map/view/edit_gesture.h"

#include "widgets/document/scenario_document.h"

#include <QScopedValueRollback>
#include <QUndoStack>

using namespace Qt::StringLiterals;

namespace berg {

EditGesture::EditGesture(ScenarioDocument& document, QString text, Preview preview)
    : m_document(document)
    , m_text(std::move(text))
    , m_preview(std::move(preview))
    , m_start(document.scenario())
    , m_now(m_start)
    , m_isLive(!document.undoStack()->canRedo())
{
    m_document.endGesture();
}

EditGesture::~EditGesture()
{
    end();
}

void EditGesture::apply(const Change& change)
{
    Scenario next = m_start;
    change(next);
    m_now = std::move(next);
    const QScopedValueRollback applying(m_isApplying, true);
    if (m_isLive)
        edit(m_now);
    else
        m_preview(&m_now);
}

void EditGesture::finish()
{
    const QScopedValueRollback applying(m_isApplying, true);
    if (!m_isLive && m_isOpen)
        edit(m_now);
    end();
}

void EditGesture::cancel()
{
    const QScopedValueRollback applying(m_isApplying, true);
    if (m_isLive && m_isOpen)
        edit(m_start);
    end();
}

void EditGesture::edit(const Scenario& scenario)
{
    m_document.edit(
        m_text, [&](Scenario& s) { s = scenario; }, u"map gesture"_s);
}

void EditGesture::end()
{
    if (!m_isOpen)
        return;
    m_isOpen = false;
    if (!m_isLive)
        m_preview(nullptr);
    m_document.endGesture();
}

} // namespace berg
