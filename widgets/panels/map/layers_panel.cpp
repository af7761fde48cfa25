#include "widgets/panels/map/layers_panel.h"

#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/theme/quantity_text.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSlider>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 10;
constexpr int kFewestLetters = 14; ///< visible letters of the background's name
constexpr int kFull = 100;         ///< full opacity, per cent
constexpr int kStep = 10;
constexpr std::array<double, 8> kHorizons_s{600, 1800, 3600, 10800, 21600, 43200, 86400, 172800};
constexpr std::array<double, 5> kTrackMarks_s{3600, 10800, 21600, 43200, 86400};

} // namespace

LayersPanel::LayersPanel(QWidget* parent) : QWidget(parent)
{
    struct LayerRow
    {
        MapLayer layer;
        const char* key;
        QString name;
    };
    const std::array<LayerRow, kMapLayers> rows{
        {{MapLayer::Labels, "labels", tr("Names")},
         {MapLayer::Places, "places", tr("Place names")},
         {MapLayer::Drift, "drift", tr("Drift arrows")},
         {MapLayer::Tracks, "tracks", tr("Predicted drift")},
         {MapLayer::Rings, "rings", tr("Uncertainty rings")},
         {MapLayer::Wind, "wind", tr("Forecast wind")},
         {MapLayer::Current, "current", tr("Forecast current")},
         {MapLayer::Graticule, "graticule", tr("Graticule")},
         {MapLayer::FormerPlan, "formerPlan", tr("Former plan")},
         {MapLayer::Compared, "compared", tr("Compared run")},
         {MapLayer::Swept, "swept", tr("Swept area")},
         {MapLayer::Permit, "permit", tr("Airspace and operation volume")},
         {MapLayer::IceChart, "iceChart", tr("Ice chart")},
         {MapLayer::Backdrop, "backdrop", tr("Background")}}};
    auto* form = new QFormLayout(this);
    form->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    for (const auto& [layer, key, name] : rows) {
        auto* slider = new QSlider(Qt::Horizontal);
        slider->setObjectName(QLatin1String(key) + u"Layer"_s);
        slider->setAccessibleName(tr("%1: opacity in per cent").arg(name));
        slider->setToolTip(tr("Opacity; at the left end the layer is hidden"));
        slider->setRange(0, kFull);
        slider->setSingleStep(kStep);
        slider->setPageStep(kStep);
        slider->setValue(kFull);
        guardWheel(*slider);
        m_opacities[static_cast<std::size_t>(layer)] = slider;
        form->addRow(name, slider);
        connect(slider, &QSlider::valueChanged, this, [this, edited = layer](int value) {
            MapLayers layers = m_layers;
            layers.set(edited, static_cast<double>(value) / kFull);
            edit(layers);
        });
    }
    addBackdropRow(*form);
    m_horizon = new QComboBox;
    m_horizon->setObjectName(u"driftHorizon"_s);
    m_horizon->setToolTip(
        tr("Time covered by drift arrows; arrows too long for the map are shortened and dashed"));
    m_horizon->addItem(tr("Automatic"));
    for (const double horizon_s : kHorizons_s)
        m_horizon->addItem(durationText(horizon_s, locale()), horizon_s);
    guardWheel(*m_horizon);
    form->addRow(tr("Drift horizon"), m_horizon);
    connect(m_horizon, &QComboBox::currentIndexChanged, this, [this] {
        MapLayers layers = m_layers;
        const QVariant horizon_s = m_horizon->currentData();
        layers.horizon_s = horizon_s.isValid() ? std::optional(horizon_s.toDouble()) : std::nullopt;
        edit(layers);
    });
    addTrackMarks(*form);
}

/** Adds the time between two marks of the predicted drift. */
void LayersPanel::addTrackMarks(QFormLayout& form)
{
    m_trackMarks = new QComboBox;
    m_trackMarks->setObjectName(u"trackMarks"_s);
    m_trackMarks->setToolTip(tr("Time between two marks of the predicted drift, up to 48 h"));
    for (const double every_s : kTrackMarks_s)
        m_trackMarks->addItem(tr("every %1").arg(durationText(every_s, locale())), every_s);
    guardWheel(*m_trackMarks);
    form.addRow(tr("Marks of the drift"), m_trackMarks);
    connect(m_trackMarks, &QComboBox::currentIndexChanged, this, [this] {
        MapLayers layers = m_layers;
        layers.trackMark_s = m_trackMarks->currentData().toDouble();
        edit(layers);
    });
}

/** Adds the file of the background and its buttons below the background's slider. */
void LayersPanel::addBackdropRow(QFormLayout& form)
{
    auto* row = new QHBoxLayout;
    m_open = new QPushButton;
    m_open->setObjectName(u"backdropButton"_s);
    m_open->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // uses the room that is left
    m_open->setMinimumWidth(kFewestLetters * m_open->fontMetrics().averageCharWidth());
    m_open->setAutoDefault(false);
    m_remove = new QPushButton(tr("Remove"));
    m_remove->setObjectName(u"backdropRemoveButton"_s);
    m_remove->setAutoDefault(false);
    m_remove->setToolTip(tr("Removes the background"));
    connect(m_open, &QPushButton::clicked, this, &LayersPanel::backdropRequested);
    connect(m_remove, &QPushButton::clicked, this, &LayersPanel::backdropRemoved);
    row->addWidget(m_open, 1);
    row->addWidget(m_remove);
    form.addRow(QString(), row);
    showBackdrop({});
}

void LayersPanel::showBackdrop(const QString& path)
{
    const QString name = path.isEmpty() ? tr("Choose a file…") : QFileInfo(path).fileName();
    // A single & would make the next letter a mnemonic.
    m_open->setText(QString(name).replace(u'&', u"&&"_s));
    m_open->setToolTip(
        path.isEmpty()
            ? tr("Your own map below all layers, such as an ice chart: GeoJSON, KML, KMZ or "
                 "CZML")
            : QDir::toNativeSeparators(path));
    m_open->setAccessibleName(tr("Background file: %1").arg(name));
    m_remove->setVisible(!path.isEmpty());
    m_opacities[static_cast<std::size_t>(MapLayer::Backdrop)]->setEnabled(!path.isEmpty());
}

void LayersPanel::showLayers(const MapLayers& layers)
{
    m_layers = layers;
    for (std::size_t i = 0; i < kMapLayers; ++i)
        m_opacities[i]->setValue(static_cast<int>(std::lround(layers.opacities[i] * kFull)));
    const int chosen = layers.horizon_s ? m_horizon->findData(*layers.horizon_s) : 0;
    m_horizon->setCurrentIndex(std::max(0, chosen));
    m_trackMarks->setCurrentIndex(std::max(0, m_trackMarks->findData(layers.trackMark_s)));
}

/** Emits only real changes. */
void LayersPanel::edit(const MapLayers& layers)
{
    if (layers == m_layers)
        return;
    m_layers = layers;
    emit layersEdited(layers);
}

} // namespace berg
