#pragma once

#include "core/study/start_scan.h"
#include "widgets/charts/figure_view.h"

#include <optional>

namespace berg {

/** Zeta and weather by start time (`startFigure`); its items are the starts of the scan. */
class StartChart : public FigureView
{
    Q_OBJECT

public:
    explicit StartChart(const Theme& theme, QWidget* parent = nullptr);

    /** Sets the scan; nullopt if there is none, or if it `isWaiting` for one. */
    void setScan(const std::optional<StartScan>& scan, bool isWaiting = false);
    [[nodiscard]] QSize sizeHint() const override { return {720, 300}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 190}; }

protected:
    [[nodiscard]] Figure figure() const override;

private:
    std::optional<StartScan> m_scan;
    bool m_isWaiting = false;
};

} // namespace berg
