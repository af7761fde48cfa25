#pragma once

#include "widgets/map/paint/map_layers.h"

#include <QWidget>

class QComboBox;
class QSlider;

namespace berg {

/** How strongly each layer of the map is painted, and the horizon of drift. GUI thread. */
class LayersPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LayersPanel(QWidget* parent = nullptr);

    void showLayers(const MapLayers& layers);
    [[nodiscard]] const MapLayers& layers() const { return m_layers; }

signals:
    void layersEdited(const berg::MapLayers& layers);

private:
    void edit(const MapLayers& layers);

    MapLayers m_layers;
    std::array<QSlider*, kMapLayers> m_opacities{};
    QComboBox* m_horizon = nullptr;
};

} // namespace berg
