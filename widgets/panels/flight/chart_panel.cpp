#include "widgets/panels/flight/chart_panel.h"

#include "core/io/text/atomic_file.h"
#include "widgets/charts/chart_image.h"
#include "widgets/charts/time_chart.h"
#include "widgets/charts/value_table.h"
#include "widgets/tables/cell_model.h"
#include "widgets/tables/dock_table.h"
#include "widgets/theme/icons.h"

#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>

#include <algorithm>
#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 6;
constexpr int kIcon_px = 18;
constexpr int kRow_px = 17;        // of the table of values
constexpr int kMark_px = 8;        // mark in the colour of a line
constexpr int kNarrowest_px = 420; // smallest width of a panel with the table
constexpr double kMostShare = 0.4; // largest share of the width for the table

DecimationWindow viewOf(const TimeWindow& window, int columns)
{
    return {.from = window.from_s, .to = window.to_s, .columns = columns};
}

/** Returns the mark of a line: a square in its colour, which is broken if the line is dashed. */
QVariant markOf(const ReadoutFlag& flag, double pixelRatio)
{
    if (!flag.isDashed)
        return flag.colour;
    constexpr double kDash_px = 3;
    QPixmap mark(QSize(kMark_px, kMark_px) * pixelRatio);
    mark.setDevicePixelRatio(pixelRatio);
    mark.fill(Qt::transparent);
    QPainter painter(&mark);
    painter.fillRect(QRectF(0, 0, kDash_px, kMark_px), flag.colour);
    painter.fillRect(QRectF(kMark_px - kDash_px, 0, kDash_px, kMark_px), flag.colour);
    return mark;
}

} // namespace

ChartPanel::ChartPanel(ChartKind kind, const Theme& theme, QWidget* parent)
    : QWidget(parent), m_series(kind), m_theme(theme)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, kMargin_px, 0, 0);
    column->setSpacing(0);
    addRow();
    addBody();
    column->addWidget(m_body, 1);
    connectChart();
    setTheme(theme);
    m_empty = emptyChart(kind, {}, locale());
    refresh();
}

void ChartPanel::addBody()
{
    m_chart = new TimeChart(m_theme);
    m_chart->setObjectName(u"timeChart"_s);
    m_chart->setTitleShown(false); // the row above names the chart
    m_values = addValueAction(*m_chart);
    connect(m_values, &QAction::triggered, this, &ChartPanel::showValues);
    m_lineValues = new CellModel(this);
    m_lineTable = new QTableView;
    m_lineTable->setObjectName(u"lineValues"_s);
    m_lineTable->setAccessibleName(tr("Values of the lines"));
    m_lineTable->setModel(m_lineValues);
    setUpDockTable(*m_lineTable, kRow_px);
    m_lineTable->setSelectionMode(QAbstractItemView::NoSelection);
    m_lineTable->setFocusPolicy(Qt::NoFocus); // the chart has the keys
    m_lineTable->setIconSize({kMark_px, kMark_px});
    m_lineTable->horizontalHeader()->hide();
    m_lineTable->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_lineTable->hide();
    m_body = new QWidget;
    auto* row = new QHBoxLayout(m_body);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_chart, 1);
    row->addWidget(m_lineTable);
}

QToolButton* ChartPanel::addButton(const QString& name, const QString& text, const QString& toolTip)
{
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(text);
    button->setAccessibleName(text);
    button->setToolTip(toolTip);
    button->setAutoRaise(true);
    button->setIconSize({kIcon_px, kIcon_px});
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

void ChartPanel::addRow()
{
    m_kind = new QComboBox;
    m_kind->setObjectName(u"chartKind"_s);
    m_kind->setAccessibleName(tr("Chart"));
    m_kind->setToolTip(tr("Quantity shown over time"));
    m_kind->setMinimumContentsLength(8);
    m_kind->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const ChartKind kind : kChartKinds)
        m_kind->addItem(chartKindName(kind));
    m_kind->setCurrentIndex(static_cast<int>(kind()));
    connect(m_kind, &QComboBox::currentIndexChanged, this,
            [this](int index) { setKind(kChartKinds.at(static_cast<std::size_t>(index))); });

    m_lines = addButton(u"chartLines"_s, tr("Lines"), tr("Choose the lines to show"));
    m_menu = new QMenu(m_lines);
    m_menu->setObjectName(u"chartLinesMenu"_s);
    m_lines->setMenu(m_menu);
    m_lines->setPopupMode(QToolButton::InstantPopup);
    m_lines->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_follow = addButton(u"chartFollow"_s, tr("Follow"),
                         tr("Keep the newest minutes in view (End). The wheel zooms, the right "
                            "button drags."));
    m_follow->setCheckable(true);
    m_all = addButton(u"chartAll"_s, tr("All"),
                      tr("Show everything from take-off on (Home, or a double click)"));
    m_export = addButton(u"chartExport"_s, tr("Export…"),
                         tr("Save the chart as a picture (PNG, SVG, PDF) or its numbers as CSV"));
    connect(m_export, &QToolButton::clicked, this, &ChartPanel::exportRequested);

    auto* row = new QHBoxLayout;
    row->setContentsMargins(kMargin_px, 0, kMargin_px, 0);
    row->setSpacing(2);
    row->addWidget(m_kind, 1);
    for (QToolButton* button : {m_lines, m_follow, m_all, m_export})
        row->addWidget(button);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void ChartPanel::connectChart()
{
    connect(m_follow, &QToolButton::toggled, m_chart, &TimeChart::setFollowing);
    connect(m_all, &QToolButton::clicked, m_chart, &TimeChart::showAll);
    connect(m_chart, &TimeChart::windowChanged, this, &ChartPanel::refresh);
    connect(m_chart, &TimeChart::timePicked, this, &ChartPanel::timePicked);
    connect(m_chart, &TimeChart::menuRequested, this, &ChartPanel::showMenu);
    connect(m_chart, &TimeChart::readoutChanged, this, &ChartPanel::showLineValues);
    connect(m_chart, &TimeChart::linePicked, this, &ChartPanel::pickLine);
    connect(m_lineTable, &QTableView::clicked, this, [this](const QModelIndex& index) {
        pickLine(m_chart->readout().flags.at(static_cast<std::size_t>(index.row())).key);
    });
}

void ChartPanel::pickLine(const QString& key)
{
    if (kind() == ChartKind::Sigma)
        emit icebergPicked(key.toStdString());
}

/** Shows the values beside the chart if the panel is wide enough, else they are at the lines. */
void ChartPanel::showLineValues()
{
    const bool isWide = width() >= kNarrowest_px && hasPoints(m_chart->content());
    m_chart->setValuesBeside(isWide);
    if (!isWide)
        return m_lineTable->hide();
    const auto flags = std::make_shared<const std::vector<ReadoutFlag>>(m_chart->readout().flags);
    const auto flagAt = [flags](int row) -> const ReadoutFlag& {
        return flags->at(static_cast<std::size_t>(row));
    };
    QFont bold = m_lineTable->font();
    bold.setBold(true);
    m_lineValues->setSheet(
        {.columns = withNumbers(
             {{.title = tr("Line"), .text = [flagAt](int row) { return flagAt(row).name; }},
              {.title = tr("Value"),
               .text =
                   [flagAt](int row) {
                       return (flagAt(row).value + u' ' + flagAt(row).unit).trimmed();
                   }}}),
         .rows = static_cast<int>(flags->size()),
         .other = [this, flagAt, bold](int row, int column, int role) -> QVariant {
             if (role == Qt::DecorationRole && column == 0)
                 return markOf(flagAt(row), m_lineTable->devicePixelRatioF());
             return role == Qt::FontRole && flagAt(row).isStrong ? QVariant(bold) : QVariant();
         }});
    fitLineTable();
    m_lineTable->show();
}

/** Columns do not become narrower while numbers change, so that the plot keeps its width. */
void ChartPanel::fitLineTable()
{
    m_lineTable->resizeColumnsToContents();
    for (std::size_t column = 0; column < m_columns_px.size(); ++column)
        m_columns_px[column] =
            std::max(m_columns_px[column], m_lineTable->columnWidth(static_cast<int>(column)));
    const auto [name_px, value_px] = m_columns_px;
    const int most_px = static_cast<int>(kMostShare * width());
    const int table_px = std::min(name_px + value_px, most_px);
    const bool isLong = m_lineValues->rowCount() * kRow_px > m_lineTable->height();
    const int bar_px = isLong ? m_lineTable->verticalScrollBar()->sizeHint().width() : 0;
    m_lineTable->setColumnWidth(0, std::max(table_px - value_px, 0));
    m_lineTable->setColumnWidth(1, value_px);
    m_lineTable->setFixedWidth(table_px + bar_px);
}

void ChartPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    showLineValues();
}

void ChartPanel::showMenu(const QPoint& globalPos)
{
    auto* menu = new QMenu(this);
    menu->setObjectName(u"chartMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool hasLines = !m_empty.lines.empty();
    menu->addAction(m_values);
    menu->addAction(tr("Copy picture"), this, &ChartPanel::copyPicture);
    menu->addAction(tr("Copy numbers"), this, &ChartPanel::copyNumbers)->setEnabled(hasLines);
    menu->addAction(tr("Save picture or numbers..."), this, &ChartPanel::exportRequested)
        ->setEnabled(hasLines);
    menu->addSeparator();
    menu->addAction(tr("Reset zoom"), m_chart, &TimeChart::showAll)
        ->setEnabled(m_chart->isZoomed());
    QAction* follow = menu->addAction(tr("Follow"), m_chart, &TimeChart::setFollowing);
    follow->setCheckable(true);
    follow->setChecked(m_chart->isFollowing());
    menu->popup(globalPos);
}

/** Copies the chart as it is on screen. */
void ChartPanel::copyPicture() const
{
    QApplication::clipboard()->setPixmap(m_body->grab());
}

/** Copies the values of the whole flight as text for a spreadsheet. */
void ChartPanel::copyNumbers() const
{
    QApplication::clipboard()->setText(QString::fromStdString(m_series.csv(m_empty)));
}

void ChartPanel::showValues()
{
    ValueTable::open(m_empty.title, m_series.values(m_empty, locale()), this);
}

void ChartPanel::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_follow->setIcon(icon(IconName::Follow, theme));
    m_all->setIcon(icon(IconName::Fit, theme));
    m_export->setIcon(icon(IconName::ExportPlan, theme));
    m_chart->setTheme(theme);
    m_lineTable->setFont(theme.small());
    QPalette palette = m_lineTable->palette();
    palette.setColor(QPalette::Base, theme.chart);
    palette.setColor(QPalette::Text, theme.text);
    m_lineTable->setPalette(palette);
    m_columns_px = {};
    showLineValues();
}

bool ChartPanel::isShown(const FlightRecord& record) const
{
    if (record.now.phase != RunPhase::Flying || m_phase != RunPhase::Flying ||
        !m_series.isContinuedBy(record) || record.instant || m_wasInstant ||
        record.now.icebergs.size() != m_icebergs || record.boundOfFlight().whole != m_bound ||
        record.weather != m_weather)
        return false;
    const double column_s = m_chart->window().length_s() / m_chart->columns();
    return record.now.time_s - m_empty.cursor_s.value_or(m_empty.duration_s) < column_s / 2;
}

void ChartPanel::showRecord(const FlightRecord& record)
{
    if (isShown(record))
        return;
    m_phase = record.now.phase;
    m_icebergs = record.now.icebergs.size();
    m_bound = record.boundOfFlight().whole;
    m_weather = record.weather;
    m_wasInstant = record.instant.has_value();
    m_empty = emptyChart(kind(), record, locale());
    m_series.update(record, m_empty.lines.size());
    addMenuEntries();
    refresh();
}

void ChartPanel::setKind(ChartKind kind)
{
    if (kind == this->kind())
        return;
    m_series = MissionSeries(kind);
    m_empty = emptyChart(kind, {}, locale());
    m_hidden.clear();
    m_kind->setCurrentIndex(static_cast<int>(kind));
    addMenuEntries();
    refresh();
    emit kindChanged(kind);
}

void ChartPanel::linkTimes(ChartPanel& a, ChartPanel& b)
{
    const auto link = [](const ChartPanel& from, ChartPanel& to) {
        connect(from.m_chart, &TimeChart::windowChanged, to.m_chart,
                [&from, &to] { to.m_chart->shareWindow(*from.m_chart); });
    };
    link(a, b);
    link(b, a);
}

void ChartPanel::setHighlight(const std::string& id)
{
    const QString key = QString::fromStdString(id);
    if (key == m_highlight)
        return;
    m_highlight = key;
    refresh();
}

void ChartPanel::addMenuEntries()
{
    QStringList names;
    for (const TimeLine& line : m_empty.lines)
        if (!line.isContinued)
            names << line.shownName();
    if (names == m_listed)
        return;
    m_listed = names;
    m_columns_px = {};
    m_menu->clear();
    m_menu->addAction(tr("Show all"), this, &ChartPanel::showAllLines);
    m_menu->addSeparator();
    for (const TimeLine& line : m_empty.lines) {
        if (line.isContinued)
            continue;
        QAction* action = m_menu->addAction(line.shownName());
        action->setObjectName(line.key);
        action->setCheckable(true);
        action->setChecked(!m_hidden.contains(line.key));
        connect(action, &QAction::toggled, this,
                [this, key = line.key](bool shown) { setShown(key, shown); });
    }
}

void ChartPanel::setShown(const QString& key, bool shown)
{
    if (shown)
        m_hidden.erase(key);
    else
        m_hidden.insert(key);
    refresh();
}

void ChartPanel::showAllLines()
{
    for (QAction* action : m_menu->actions())
        if (action->isCheckable())
            action->setChecked(true);
}

void ChartPanel::applyLines(TimeChartContent& content) const
{
    const bool found =
        kind() == ChartKind::Sigma && !m_highlight.isEmpty() &&
        std::any_of(content.lines.begin(), content.lines.end(),
                    [this](const TimeLine& line) { return line.key == m_highlight; });
    for (TimeLine& line : content.lines) {
        const bool isHighlight = found && line.key == m_highlight;
        // A highlighted line is always shown.
        line.hidden = !isHighlight && m_hidden.contains(line.key);
        if (found)
            line.emphasis = isHighlight ? LineEmphasis::Strong : LineEmphasis::Faint;
    }
}

void ChartPanel::refresh()
{
    TimeChartContent content = m_empty;
    applyLines(content);
    m_series.fill(content, viewOf(m_chart->windowFor(content), m_chart->columns()));
    m_chart->setContent(content);
    updateButtons();
}

void ChartPanel::updateButtons()
{
    m_follow->setChecked(m_chart->isFollowing());
    m_all->setEnabled(m_chart->isZoomed());
    m_lines->setEnabled(m_empty.lines.size() > 1);
    m_export->setEnabled(!m_empty.lines.empty());
    m_values->setEnabled(!m_empty.lines.empty());
}

void ChartPanel::exportChart(const QString& path) const
{
    if (QFileInfo(path).suffix().compare(u"csv"_s, Qt::CaseInsensitive) == 0)
        return writeFileAtomically(QFile::encodeName(path).toStdString(), m_series.csv(m_empty));
    const ChartPage page{.window =
                             m_chart->isZoomed() ? std::optional(m_chart->window()) : std::nullopt};
    TimeChartContent content = m_empty;
    content.cursor_s.reset(); // the cursor belongs to the screen only
    applyLines(content);
    m_series.fill(content, viewOf(m_chart->window(), page.size_px.width()));
    writeChartPicture(content, m_theme, page, path);
}

QString ChartPanel::exportFilters()
{
    return (pictureFilters() << tr("Table of numbers (*.csv)")).join(u";;"_s);
}

QStringList ChartPanel::pictureFilters()
{
    return {tr("PNG picture (*.png)"), tr("SVG drawing (*.svg)"), tr("PDF page (*.pdf)")};
}

QString ChartPanel::exportName() const
{
    return chartFileStem(kind()) + u".png"_s;
}

} // namespace berg
