#include "app/dialogs/forecast_dialog.h"

#include "core/io/import/import_forecast_file.h"
#include "core/scenario/utc_time.h"
#include "widgets/tables/dock_table.h"
#include "widgets/theme/quantity_text.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr qint64 kReport_ms = 50;
constexpr int kMostRows = 200;
constexpr int kMostGaps = 5;
constexpr int kForecastRow_px = 24;
constexpr QSize kUsualSize(640, 480);

QString shownTime(ForecastTime time)
{
    return QString::fromStdString(utcText(time, 0));
}

/** Returns the cell of a number; empty for a missing one. */
QString numberCell(const std::optional<double>& value, int decimals, const QLocale& locale)
{
    return value ? fixedText(*value, decimals, locale) : QString();
}

/** Returns a speed and the direction from which, or to which, it goes. */
QString velocityCell(const std::optional<Point>& velocity_mps, bool isFrom, int decimals,
                     const QLocale& locale)
{
    if (!velocity_mps)
        return {};
    const Point shown = isFrom ? Point(-*velocity_mps) : *velocity_mps;
    const double heading_deg = std::atan2(shown.x(), shown.y()) * 180 / std::acos(-1.0);
    QString speed = fixedSpeedText(velocity_mps->norm(), decimals, locale);
    if (velocity_mps->norm() == 0)
        return speed;
    return speed + u' ' + directionText(heading_deg < 0 ? heading_deg + 360 : heading_deg);
}

} // namespace

ForecastDialog::ForecastDialog(ForecastOffer offer, QWidget* parent)
    : QDialog(parent)
    , m_offer(std::move(offer))
    , m_shown(m_offer.scenario->forecast)
    , m_task(u"forecast"_s,
             {.work =
                  [](const Request& request, const std::stop_token& stop, const auto& deliver) {
                      ReportPace pace(kReport_ms);
                      const ForecastReading reading = loadForecastFile(
                          QFile::encodeName(request.path).toStdString(),
                          forecastOptions(*request.scenario),
                          [&](double share) {
                              if (pace.isDue())
                                  deliver({.share = share, .reading = nullptr});
                          },
                          stop);
                      deliver({.share = 1,
                               .reading = std::make_shared<const ForecastReading>(reading)});
                  },
              .deliver = [this](const Message& message) { takeMessage(message); },
              .end = [this](const std::optional<WorkFailure>& failure) { end(failure); }})
{
    setWindowTitle(tr("Forecast"));
    m_summary = new QLabel;
    m_summary->setObjectName(u"forecastSummary"_s);
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    m_note = new QLabel;
    m_note->setObjectName(u"forecastNote"_s);
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::PlainText);
    m_table = new QTableWidget(0, 8);
    m_table->setObjectName(u"forecastTable"_s);
    m_table->setHorizontalHeaderLabels({tr("Time"), tr("Wind from"), tr("Gust"), tr("Air, °C"),
                                        tr("Dew point, °C"), tr("Visibility"), tr("Cloud base"),
                                        tr("Current to")});
    m_table->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setUpDockTable(*m_table, kForecastRow_px);
    m_table->setFrameShape(QFrame::StyledPanel);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_progress = new QProgressBar;
    m_progress->setObjectName(u"forecastProgress"_s);
    m_progress->hide();
    m_combine = new QCheckBox(tr("Co&mbine with the present forecast"));
    m_combine->setObjectName(u"combineForecasts"_s);
    m_combine->setChecked(true);
    m_combine->setVisible(m_offer.scenario->forecast.has_value());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* open = buttons->addButton(tr("&Open file..."), QDialogButtonBox::ActionRole);
    open->setObjectName(u"openForecastButton"_s);
    m_remove = buttons->addButton(tr("&Remove"), QDialogButtonBox::ActionRole);
    m_remove->setObjectName(u"removeForecastButton"_s);
    m_set = buttons->addButton(tr("&Set"), QDialogButtonBox::AcceptRole);
    m_set->setObjectName(u"setForecastButton"_s);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_summary);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_progress);
    layout->addWidget(m_note);
    layout->addWidget(m_combine);
    layout->addWidget(buttons);
    m_set->setDefault(true);
    connect(open, &QPushButton::clicked, this, &ForecastDialog::openFile);
    connect(m_remove, &QPushButton::clicked, this, [this] {
        m_task.drop();
        m_progress->hide();
        m_reading = nullptr;
        m_shown.reset();
        m_gaps.clear();
        showShown();
    });
    connect(m_combine, &QCheckBox::toggled, this, &ForecastDialog::combine);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resize(kUsualSize);
    showShown();
}

void ForecastDialog::openFile()
{
    if (const QString path = m_offer.openPath(this); !path.isEmpty())
        read(path);
}

void ForecastDialog::read(const QString& path)
{
    m_path = path;
    m_note->clear();
    m_progress->setValue(0);
    m_progress->show();
    m_set->setEnabled(false);
    m_task.start({.path = path, .scenario = m_offer.scenario});
}

void ForecastDialog::takeMessage(const Message& message)
{
    m_progress->setValue(static_cast<int>(std::lround(100 * message.share)));
    if (!message.reading)
        return;
    m_reading = message.reading;
    combine();
}

void ForecastDialog::end(const std::optional<WorkFailure>& failure)
{
    m_progress->hide();
    if (!failure)
        return;
    showShown();
    m_note->setText(failure->report);
}

void ForecastDialog::combine()
{
    if (!m_reading)
        return;
    const auto failure = failureOf([&] {
        const ForecastImport made = withForecast(*m_offer.scenario, *m_reading,
                                                 m_path.toStdString(), !m_combine->isChecked());
        m_shown = made.scenario.forecast;
        m_gaps = made.gaps;
    });
    showShown();
    if (failure)
        m_note->setText(failure->report);
}

QString ForecastDialog::summary(const ForecastField& field) const
{
    const Forecast& first = field.places.front();
    QStringList lines{tr("Source: %1").arg(QString::fromStdString(first.source))};
    const std::optional<UtcTime> start = parseUtc(m_offer.scenario->startUtc);
    const std::optional<double> age_h = start ? ageAt_h(first, *start) : std::nullopt;
    if (!first.issued)
        lines << tr("Time of issue unknown");
    else if (!age_h)
        lines << tr("Issued %1").arg(shownTime(*first.issued));
    else if (*age_h > kOldForecast_h)
        lines << tr("Issued %1, %2 h before the start: get a newer forecast")
                     .arg(shownTime(*first.issued), fixedText(*age_h, 0, locale()));
    else
        lines << tr("Issued %1, %2 h before the start")
                     .arg(shownTime(*first.issued), fixedText(*age_h, 0, locale()));
    lines << tr("%n places, the table is for the middle one", nullptr,
                static_cast<int>(field.places.size()));
    if (!first.series.empty())
        lines << tr("%n times, from %1 to %2", nullptr, static_cast<int>(first.series.size()))
                     .arg(shownTime(first.series.front().time),
                          shownTime(first.series.back().time));
    if (m_reading && m_reading->thinning > 1)
        lines << tr("Thinned by a factor of %1 in each direction").arg(m_reading->thinning);
    return lines.join(u'\n');
}

void ForecastDialog::showShown()
{
    const bool isGiven = m_shown && !m_shown->places.empty() && isGrid(*m_shown);
    m_note->clear();
    m_table->setRowCount(0);
    m_remove->setEnabled(m_shown.has_value());
    m_set->setEnabled(m_shown != m_offer.scenario->forecast);
    if (!isGiven) {
        m_summary->setText(tr("The scenario has no forecast: wind and current are constant."));
        return;
    }
    m_summary->setText(summary(*m_shown));
    showTable(middleOf(*m_shown));
    QStringList gaps;
    for (const ForecastGap& gap : m_gaps)
        if (gaps.size() < kMostGaps)
            gaps << tr("No values of one quantity between %1 and %2")
                        .arg(shownTime(gap.from), shownTime(gap.to));
    gaps.removeDuplicates();
    m_note->setText(gaps.join(u'\n'));
}

void ForecastDialog::showTable(const Forecast& forecast)
{
    const int rows = std::min(kMostRows, static_cast<int>(forecast.series.size()));
    m_table->setRowCount(rows);
    std::array<bool, 8> isUsed{true};
    for (int row = 0; row < rows; ++row) {
        const ForecastEntry& entry = forecast.series[static_cast<std::size_t>(row)];
        const auto height = [&](const std::optional<double>& height_m) {
            return height_m ? heightText(*height_m, locale()) : QString();
        };
        const std::array<QString, 8> cells{
            shownTime(entry.time),
            velocityCell(entry.wind_mps, true, 1, locale()),
            entry.gust_mps ? fixedSpeedText(*entry.gust_mps, 1, locale()) : QString(),
            numberCell(entry.airTemperature_degC, 1, locale()),
            numberCell(entry.dewPoint_degC, 1, locale()),
            entry.visibility_m ? distanceText(*entry.visibility_m, locale()) : QString(),
            height(entry.ceiling_m),
            velocityCell(entry.current_mps, false, 2, locale())};
        for (int column = 0; column < 8; ++column) {
            const QString& cell = cells[static_cast<std::size_t>(column)];
            auto* item = new QTableWidgetItem(cell);
            if (column > 0)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_table->setItem(row, column, item);
            isUsed[static_cast<std::size_t>(column)] |= !cell.isEmpty();
        }
    }
    for (int column = 0; column < 8; ++column)
        m_table->setColumnHidden(column, !isUsed[static_cast<std::size_t>(column)]);
    m_table->resizeColumnsToContents();
}

} // namespace berg
