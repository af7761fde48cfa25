#include "widgets/panels/dialogs/layers_panel.h"

#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/theme/quantity_text.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSlider>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 10;
constexpr int kFull = 100; ///< percent
constexpr int kStep = 10;
constexpr std::array<double, 8> kHorizons_s{600, 1800, 3600, 10800, 21600, 43200, 86400, 172800};

} // namespace

LayersPanel::LayersPanel(QWidget* parent) : QWidget(parent)
{
    const std::array<std::pair<const char*, QString>, kMapLayers> names{
        {{"labels", tr("Names")},
         {"drift", tr("Drift arrows")},
         {"rings", tr("Rings of uncertainty")},
         {"graticule", tr("Graticule")},
         {"formerPlan", tr("Former plan")},
         {"swept", tr("Swept area")},
         {"permit", tr("Airspace and operation volume")}}};
    auto* form = new QFormLayout(this);
    form->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    for (std::size_t i = 0; i < kMapLayers; ++i) {
        auto* slider = new QSlider(Qt::Horizontal);
        slider->setObjectName(QLatin1String(names[i].first) + u"Layer"_s);
        slider->setAccessibleName(tr("%1: opacity in per cent").arg(names[i].second));
        slider->setToolTip(tr("Opacity; at the left end it is hidden"));
        slider->setRange(0, kFull);
        slider->setSingleStep(kStep);
        slider->setPageStep(kStep);
        slider->setValue(kFull);
        guardWheel(*slider);
        m_opacities[i] = slider;
        form->addRow(names[i].second, slider);
        connect(slider, &QSlider::valueChanged, this, [this, i](int value) {
            MapLayers layers = m_layers;
            layers.set(static_cast<MapLayer>(i), static_cast<double>(value) / kFull);
            edit(layers);
        });
    }
    m_horizon = new QComboBox;
    m_horizon->setObjectName(u"driftHorizon"_s);
    m_horizon->setToolTip(tr("How far ahead drift arrows look; those too long for the map are cut "
                             "short and dashed"));
    m_horizon->addItem(tr("Automatic"), 0.0);
    for (const double horizon_s : kHorizons_s)
        m_horizon->addItem(durationText(horizon_s, locale()), horizon_s);
    guardWheel(*m_horizon);
    form->addRow(tr("Drift horizon"), m_horizon);
    connect(m_horizon, &QComboBox::currentIndexChanged, this, [this] {
        MapLayers layers = m_layers;
        layers.horizon_s = m_horizon->currentData().toDouble();
        edit(layers);
    });
}

void LayersPanel::showLayers(const MapLayers& layers)
{
    m_layers = layers;
    for (std::size_t i = 0; i < kMapLayers; ++i)
        m_opacities[i]->setValue(static_cast<int>(std::lround(layers.opacities[i] * kFull)));
    m_horizon->setCurrentIndex(std::max(0, m_horizon->findData(layers.horizon_s)));
}

/** What is shown already is no news. */
void LayersPanel::edit(const MapLayers& layers)
{
    if (layers == m_layers)
        return;
    m_layers = layers;
    emit layersEdited(layers);
}

} // namespace berg
