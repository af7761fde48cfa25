#include "widgets/panels/flight/event_panel.h"

#include "widgets/panels/flight/event_model.h"
#include "widgets/tables/dock_table.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kRow_px = 22;
constexpr int kWhatColumn_px = 220;
constexpr int kCellMargins_px = 10;

/** Mutes the events after the instant shown. */
class EventDelegate final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.data(EventModel::AheadRole).toBool())
            option->palette.setColor(QPalette::Text,
                                     option->palette.color(QPalette::PlaceholderText));
    }
};

} // namespace

EventPanel::EventPanel(QWidget* parent)
    : QWidget(parent), m_model(new EventModel(locale(), this)), m_table(new QTableView)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_table);
    m_table->setObjectName(u"eventTable"_s);
    m_table->setAccessibleName(tr("Events of the mission"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new EventDelegate(m_table));
    setUpDockTable(*m_table, kRow_px);
    QHeaderView* header = m_table->horizontalHeader();
    header->setStretchLastSection(true);
    m_table->setColumnWidth(EventModel::What, kWhatColumn_px);
    const auto choose = [this](const QModelIndex& index) {
        if (index.isValid())
            emit timeChosen(m_model->time_s(index.row()));
    };
    connect(m_table, &QTableView::clicked, this, choose);
    connect(m_table, &QTableView::activated, this, choose);
    const QScrollBar* bar = m_table->verticalScrollBar();
    connect(bar, &QScrollBar::actionTriggered, this,
            [this, bar] { m_follows = bar->sliderPosition() >= bar->maximum(); });
    setTheme(Theme::light());
}

void EventPanel::setTheme(const Theme& theme)
{
    setDockTableTheme(*m_table, theme);
    m_table->setColumnWidth(EventModel::Time,
                            m_table->fontMetrics().horizontalAdvance(u"00:00:00Z +1"_s) +
                                kCellMargins_px);
}

void EventPanel::showRecord(const FlightRecord& record)
{
    m_model->setClock(clockOf(record.scenario));
    m_model->setHistory(record.history, record.now.icebergs, record.scenario.uavs);
    m_model->setShown(record.eventsShown());
    if (record.instant && m_model->shownRows() > 0)
        m_table->scrollTo(m_model->index(m_model->shownRows() - 1, 0));
    else if (m_follows)
        m_table->scrollToBottom();
}

} // namespace berg
