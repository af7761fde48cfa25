#pragma once

#include "widgets/charts/study_chart.h"

namespace berg {

/**
 * How each setting compares with the reference, case by case: mean difference with its 95 %
 * confidence interval, a row for each policy and as many values of tau as there is room for.
 */
class DifferenceChart : public StudyPicture
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
