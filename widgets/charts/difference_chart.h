#pragma once

#include "widgets/charts/study_chart.h"

namespace berg {

/**
 * Paired comparison of each setting with the reference: mean difference with its 95 % confidence
 * interval. It has a row per policy and as many values of tau as fit.
 */
class DifferenceChart : public StudyFigure
{
    Q_OBJECT

public:
    explicit DifferenceChart(const Theme& theme, QWidget* parent = nullptr);

protected:
    [[nodiscard]] Figure figure() const override;

private:
    void addRow(Figure& figure, const DifferenceRow& row) const;
    [[nodiscard]] std::vector<std::string> readout(std::size_t setting) const;
};

} // namespace berg
