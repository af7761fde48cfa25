#pragma once

#include "widgets/map/paint/map_layers.h"

#include <QWidget>

class QComboBox;
class QFormLayout;
class QPushButton;
class QSlider;

namespace berg {

/** Sliders for the opacity of each map layer, and the horizon of drift arrows. GUI thread. */
class LayersPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LayersPanel(QWidget* parent = nullptr);

    void showLayers(const MapLayers& layers);
    [[nodiscard]] const MapLayers& layers() const { return m_layers; }
    /** Shows the file of the background; an empty path means no background. */
    void showBackdrop(const QString& path);

signals:
    void layersEdited(const berg::MapLayers& layers);
    void backdropRequested();
    void backdropRemoved();

private:
    void addBackdropRow(QFormLayout& form);
    void addTrackMarks(QFormLayout& form);
    void edit(const MapLayers& layers);

    MapLayers m_layers;
    std::array<QSlider*, kMapLayers> m_opacities{};
    QComboBox* m_horizon = nullptr;
    QComboBox* m_trackMarks = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_remove = nullptr;
};

} // namespace berg
