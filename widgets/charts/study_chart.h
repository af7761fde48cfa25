#pragma once

#include "widgets/charts/figure_view.h"
#include "widgets/charts/study_content.h"
#include "widgets/study/study_runner.h"

namespace berg {

/** Base of the figures of a study, whose items are the study's settings. */
class StudyFigure : public FigureView
{
    Q_OBJECT

public:
    using FigureView::FigureView;

    /** Sets the result; null if there is none yet. */
    void setResult(const StudyPointer& result);
    [[nodiscard]] QSize sizeHint() const override { return {720, 320}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {360, 190}; }

protected:
    [[nodiscard]] const StudySummary& summary() const { return m_result->summary; }
    [[nodiscard]] bool hasCases() const { return m_result && !m_result->summary.cases.empty(); }
    [[nodiscard]] bool hasSpread() const { return summary().cases.size() > 1; }
    [[nodiscard]] QString nameOfSetting(std::size_t setting) const;
    [[nodiscard]] QString nameOfReference() const { return nameOfSetting(summary().reference); }
    /** Figure with title such as "Grand Banks, 100 cases", or with `emptyText` without cases. */
    [[nodiscard]] Figure titled(const QString& name, const QString& emptyText) const;

private:
    StudyPointer m_result;
};

/**
 * zeta against tau, as in Figure 4 of the paper: mean with a band between the quartiles, median
 * dashed; points only for a single case. The other policies are horizontal lines with marks right
 * of the largest tau; the shortest path is labelled TSP as in the paper. Less is better.
 */
class StudyChart : public StudyFigure
{
    Q_OBJECT

public:
    explicit StudyChart(const Theme& theme, QWidget* parent = nullptr);

protected:
    [[nodiscard]] Figure figure() const override;

private:
    void addTitles(Figure& figure, const ZetaContent& content) const;
    void addCurve(Figure& figure, const ZetaContent& content) const;
    void addPolicies(Figure& figure, const ZetaContent& content) const;
    void addItem(Figure& figure, std::size_t setting, const PlotPoint& at) const;
    [[nodiscard]] std::vector<std::string> readout(std::size_t setting) const;
};

} // namespace berg
