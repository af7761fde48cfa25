#pragma once

#include "core/base/nice_ticks.h"
#include "widgets/charts/study_picture.h"

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

    [[nodiscard]] QStringList readout(std::size_t setting) const override;
    [[nodiscard]] const std::vector<DifferenceRow>& rows() const { return m_rows; }

protected:
    void layOut() override;
    void paintContent(QPainter& painter) const override;

private:
    void fillTitles();
    void setAxis();
    void setTicks();
    [[nodiscard]] double x_px(double share) const;
    [[nodiscard]] double y_px(std::size_t row) const;
    void paintRow(QPainter& painter, std::size_t row) const;

    std::vector<DifferenceRow> m_rows;
    NiceTicks m_ticks; ///< per cent
};

} // namespace berg
