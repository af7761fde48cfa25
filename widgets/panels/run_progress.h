#pragma once

#include "widgets/theme/theme.h"

#include <QProgressBar>

namespace berg {

/** A slim bar of how much of the run has been flown. */
class RunProgress : public QProgressBar
{
    Q_OBJECT

public:
    explicit RunProgress(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showTime(double time_s, double duration_s);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Theme m_theme = Theme::light();
};

} // namespace berg
