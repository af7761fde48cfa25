#include "app/window/history_actions.h"

#include "app/dialogs/interaction.h"
#include "app/layout/panels.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/words/intervention_text.h"
#include "widgets/workspace/workspace.h"

#include <QAction>
#include <QMainWindow>
#include <QUndoStack>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

QString withName(const QString& command, const QString& name)
{
    return name.isEmpty() ? command : command + u' ' + name;
}

} // namespace

HistoryActions::HistoryActions(WindowContext& context)
    : WindowPart(context), m_undo(new QAction(&window())), m_redo(new QAction(&window()))
{
    m_undo->setObjectName(u"undoAction"_s);
    m_redo->setObjectName(u"redoAction"_s);
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    m_undo->setIconText(tr("Undo")); // what it undoes is in the menu; the tool bar stands still
    m_redo->setIconText(tr("Redo"));
    connect(m_undo, &QAction::triggered, this, &HistoryActions::undoLast);
    connect(m_redo, &QAction::triggered, this, [this] {
        panels().finishTyping();
        workspace().document().redo();
    });
    const QUndoStack* edits = workspace().document().undoStack();
    connect(edits, &QUndoStack::canUndoChanged, this, &HistoryActions::update);
    connect(edits, &QUndoStack::canRedoChanged, this, &HistoryActions::update);
    connect(edits, &QUndoStack::undoTextChanged, this, &HistoryActions::update);
    connect(edits, &QUndoStack::redoTextChanged, this, &HistoryActions::update);
    connect(&workspace(), &Workspace::inFlightChanged, this, &HistoryActions::update);
    connect(&workspace(), &Workspace::flightChanged, this, &HistoryActions::update);
    connect(panels().map, &MapView::statusText, this,
            &HistoryActions::update); // drawing has begun or ended
    update();
}

void HistoryActions::update()
{
    const bool locked = workspace().inFlight();
    const QUndoStack& edits = *workspace().document().undoStack();
    const std::optional<LastChange> change = workspace().undoableChange();
    const QString flown = change ? changeName(change->first) : QString();
    m_undo->setText(withName(tr("&Undo"), locked ? flown : edits.undoText()));
    m_redo->setText(withName(tr("&Redo"), edits.redoText()));
    m_undo->setEnabled(panels().map->isDrawing() ||
                       (locked ? change.has_value() : edits.canUndo()));
    m_redo->setEnabled(!locked && edits.canRedo());
}

void HistoryActions::undoLast()
{
    panels().finishTyping(); // that is what it undoes then
    if (panels().map->isDrawing())
        panels().map->undoLastPoint();
    else if (workspace().inFlight())
        undoChange();
    else
        workspace().document().undo();
}

void HistoryActions::undoChange()
{
    const std::optional<LastChange> change = workspace().undoableChange();
    if (!change)
        return;
    const FlightRecord& record = workspace().record();
    const double time_s = change->first.time_s;
    if (record.now.time_s > time_s && !interaction().askUndo(&window(), changeName(change->first),
                                                             clockOf(record.scenario).text(time_s)))
        return;
    workspace().undoChange();
}

} // namespace berg
