#pragma once

#include "widgets/charts/figure_view.h"
#include "widgets/charts/study_content.h"
#include "widgets/model/study_runner.h"

namespace berg {

/** What the figures of a study have in common: their items are its settings. */
class StudyPicture : public FigureView
{
    Q_OBJECT

public:
    using FigureView::FigureView;

    /** Null: none yet. */
    void setResult(const StudyPointer& result);
    [[nodiscard]] QSize sizeHint() const override { return {720, 320}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {360, 190}; }

protected:
    [[nodiscard]] const StudySummary& summary() const { return m_result->summary; }
    [[nodiscard]] bool hasCases() const { return m_result && !m_result->summary.cases.empty(); }
    [[nodiscard]] bool hasSpread() const { return summary().cases.size() > 1; }
    [[nodiscard]] QString nameOfSetting(std::size_t setting) const;
    [[nodiscard]] QString nameOfReference() const { return nameOfSetting(summary().reference); }
    /** With "Grand Banks, 100 cases", what was flown, as title; without cases with `emptyText`. */
    [[nodiscard]] Figure titled(const QString& name, const QString& emptyText) const;

private:
    StudyPointer m_result;
};

/**
 * zeta against tau, as Figure 4 of the paper: mean with a band between the quartiles, median
 * dashed; of a single case the points alone. The other policies are horizontal lines with their
 * marks right of the largest tau, the shortest path marked TSP as there. Less is better.
 */
class StudyChart : public StudyPicture
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
