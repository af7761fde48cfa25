#pragma once

#include "widgets/charts/chart_frame.h"
#include "widgets/charts/study_content.h"
#include "widgets/model/study_runner.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace berg {

/** Where a setting is drawn. */
struct SettingSpot
{
    std::size_t setting = 0;
    QPointF at;
};

/**
 * What the pictures of a study have in common: their settings are points to be read, clicked and
 * walked through with the arrow keys. Holds nothing of its own.
 */
class StudyPicture : public QWidget
{
    Q_OBJECT

public:
    explicit StudyPicture(const Theme& theme, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    [[nodiscard]] const Theme& theme() const { return m_theme; }
    /** Null: none yet. */
    void setResult(const StudyPointer& result);
    /** The setting that stands out. */
    void setChosen(std::optional<std::size_t> setting);
    [[nodiscard]] std::optional<std::size_t> chosen() const { return m_chosen; }
    /** Title in a row of its own: for pictures that stand alone. */
    void setTitleShown(bool shown);

    /** Settings as drawn, in the order of the arrow keys. */
    [[nodiscard]] const std::vector<SettingSpot>& spots() const { return m_spots; }
    /** What is read at a setting, one line for each quantity. */
    [[nodiscard]] virtual QStringList readout(std::size_t setting) const = 0;
    /** Everything but the focus, as on the screen. */
    void paintPicture(QPainter& painter) const;
    /** Direct labels as shown, for tests. */
    [[nodiscard]] const std::vector<ChartLabel>& labels() const { return m_frame.labels; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /** By the arrow keys. */
    void settingChosen(std::size_t setting);
    /** Its cases are wanted: clicked, or Return. */
    void settingActivated(std::size_t setting);

protected:
    /** Fills `m_frame` and `m_spots` for the size there is. */
    virtual void layOut() = 0;
    /** Under the frame, inside the plot. */
    virtual void paintContent(QPainter& painter) const = 0;

    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

    void refresh();
    [[nodiscard]] const StudySummary& summary() const { return m_result->summary; }
    [[nodiscard]] bool hasCases() const { return m_result && !m_result->summary.cases.empty(); }
    /** "Grand Banks, 100 cases": what was flown. */
    [[nodiscard]] QString studyTitle() const;

    Theme m_theme;
    ChartFrame m_frame;
    std::vector<SettingSpot> m_spots;

private:
    void setHovered(std::optional<std::size_t> setting);
    void choose(std::size_t spot);
    [[nodiscard]] std::optional<std::size_t> settingNear(const QPointF& at) const;
    [[nodiscard]] const SettingSpot* spotOf(std::optional<std::size_t> setting) const;
    void paintChosen(QPainter& painter) const;
    void paintReadoutBox(QPainter& painter, const SettingSpot& spot) const;

    StudyPointer m_result;
    std::optional<std::size_t> m_chosen;
    std::optional<std::size_t> m_hovered;
    bool m_titleShown = false;
};

} // namespace berg
