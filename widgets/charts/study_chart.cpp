#include "widgets/charts/study_chart.h"

#include "core/io/figure/policy_style.h"
#include "widgets/charts/figure_text.h"
#include "widgets/words/policy_words.h"
#include "widgets/words/report_language.h"

#include <QPainter>

#include <algorithm>

namespace berg {
namespace {

StudyFigureFormat formatOf(const QLocale& locale)
{
    constexpr int kDigits = 4;
    return {
        .words = reportLanguage(),
        .setting =
            [locale](const StudySetting& setting) { return utf8(settingText(setting, locale)); },
        .number = numberText(locale),
        .zeta =
            [locale](double zeta_m2s) { return utf8(significantText(zeta_m2s, kDigits, locale)); },
        .change = [locale](double share) { return utf8(changeText(share, locale)); },
        .unit =
            [](double largest_m2s) {
                const ShownUnit unit = zetaUnit(largest_m2s);
                return FigureUnit{.name = utf8(unit.name), .inSi = unit.inSi};
            }};
}

} // namespace

QPixmap policyPixmap(PolicyKind policy, const Theme& theme, int size_px)
{
    constexpr int kScale = 2; // device pixels
    QPixmap pixmap(kScale * size_px, kScale * size_px);
    pixmap.setDevicePixelRatio(kScale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMark(painter, {size_px / 2.0, size_px / 2.0}, policyMark(policy, size_px / 3.0), theme);
    return pixmap;
}

StudyChart::StudyChart(StudyFigureKind kind, const Theme& theme, QWidget* parent)
    : FigureView(theme, parent), m_kind(kind)
{
    refresh();
}

void StudyChart::setResult(const StudyPointer& result)
{
    m_result = result;
    forgetItems(result ? result->summary.settings.size() : 0);
    refresh();
}

Figure StudyChart::figureOf(const StudySummary& summary) const
{
    const StudyFigureFormat format = formatOf(locale());
    if (m_kind == StudyFigureKind::Zeta)
        return zetaFigure(summary, format, width());
    constexpr double kRow_px = 20;
    const double room_px = std::max(kRow_px, height() - kFigureTop_px - kFigureBottom_px);
    return differenceFigure(
        summary, differenceRows(summary, static_cast<std::size_t>(room_px / kRow_px)), format);
}

Figure StudyChart::figure() const
{
    Figure figure = figureOf(m_result ? m_result->summary : StudySummary());
    if (!m_result || m_result->summary.cases.empty()) {
        figure.emptyText =
            utf8(m_kind == StudyFigureKind::Zeta
                     ? tr("Choose what to fly and press Start, or load a figure from the paper.")
                     : tr("This chart compares each setting with a reference, case by case."));
        return figure;
    }
    const QString study = QString::fromStdString(m_result->study.spec.name);
    const QString count = tr("%n cases", nullptr, static_cast<int>(m_result->summary.cases.size()));
    figure.title =
        utf8(study.isEmpty() ? count
                             : tr("%1: %2", "name of a study, how many cases").arg(study, count));
    figure.description = figure.title;
    return figure;
}

} // namespace berg
