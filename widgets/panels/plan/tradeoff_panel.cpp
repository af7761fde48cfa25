#include "widgets/panels/plan/tradeoff_panel.h"

#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/panels/plan/plan_readout_view.h"
#include "widgets/panels/plan/policy_combo.h"
#include "widgets/panels/plan/tau_strip.h"
#include "widgets/words/intervention_text.h"
#include "widgets/words/policy_words.h"

#include <QComboBox>
#include <QGridLayout>
#include <QMouseEvent>
#include <QSlider>
#include <QStandardItemModel>
#include <QStyleOptionSlider>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kSliderStep = 0.01;
constexpr int kSliderEnd = 500; ///< tau 5
constexpr int kSliderPage = 25; ///< tau 0.25
constexpr double kFieldStep = 0.05;
constexpr int kTauRest_ms = 500;
constexpr int kMargin_px = 10;
constexpr int kGroupGap_px = 6;
constexpr int kForecastGap_px = 2;

/** A slider that jumps to the position that is pressed. */
class JumpSlider final : public QSlider
{
public:
    using QSlider::QSlider;

protected:
    void mousePressEvent(QMouseEvent* event) override
    {
        QStyleOptionSlider option;
        initStyleOption(&option);
        const auto part = [&](QStyle::SubControl control) {
            return style()->subControlRect(QStyle::CC_Slider, &option, control, this);
        };
        const QRect handle = part(QStyle::SC_SliderHandle);
        const QRect groove = part(QStyle::SC_SliderGroove);
        const QPoint at = event->position().toPoint();
        if (event->button() == Qt::LeftButton && !handle.contains(at)) {
            setSliderDown(true); // part of the gesture that ends with the release
            setValue(QStyle::sliderValueFromPosition(
                minimum(), maximum(), at.x() - groove.left() - handle.width() / 2,
                groove.width() - handle.width(), option.upsideDown));
        }
        QSlider::mousePressEvent(event); // grabs the handle, now below the pointer
    }
};

int sliderPosition(double tau)
{
    return static_cast<int>(std::lround(std::clamp(tau / kSliderStep, 0.0, double{kSliderEnd})));
}

void addCombo(QComboBox* combo, QGridLayout& grid, int row, int column, int columns,
              const QString& name, const QString& label)
{
    combo->setObjectName(name);
    combo->setAccessibleName(label);
    // Long texts must not widen the panel; the list itself is as wide as they are.
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    combo->setMinimumContentsLength(8);
    combo->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    guardWheel(*combo);
    combo->setFocusPolicy(Qt::TabFocus); // a choice by mouse leaves the keyboard where it was
    auto* caption = new CaptionLabel(label);
    caption->setBuddy(combo);
    grid.addWidget(caption, row, column, 1, columns);
    grid.addWidget(combo, row + 1, column, 1, columns);
}

/** Adds a choice; one with a reason can be shown but not chosen. */
void offer(QComboBox& combo, int value, const QString& text, const QString& reason)
{
    combo.addItem(text, value);
    if (reason.isEmpty())
        return;
    const int row = combo.count() - 1;
    combo.setItemData(row, reason, Qt::ToolTipRole);
    if (auto* model = qobject_cast<QStandardItemModel*>(combo.model()))
        model->item(row)->setEnabled(false);
}

template <class Enum>
void select(QComboBox& combo, Enum value)
{
    const int row = combo.findData(static_cast<int>(value));
    if (row != combo.currentIndex())
        combo.setCurrentIndex(row);
}

bool hasBackend(Backend backend)
{
    try {
        return makeSolver(backend) != nullptr;
    } catch (const Error&) {
        return false;
    }
}

} // namespace

TradeoffPanel::TradeoffPanel(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    column->setSpacing(kGroupGap_px);
    addTau();
    addChoices();
    m_result = new PlanReadoutView(this);
    column->addWidget(m_result);
    connect(m_result, &PlanReadoutView::checksRequested, this, &TradeoffPanel::checksRequested);
    connect(m_result, &PlanReadoutView::detailsToggled, this, &TradeoffPanel::detailsToggled);
    column->addStretch();

    m_tauRest.setSingleShot(true);
    m_tauRest.setInterval(kTauRest_ms);
    connectTau();
    connectChoices();
    setTabOrder(m_slider, m_strip);
    setTabOrder(m_strip, m_tau);
    setTabOrder(m_tau, m_policy);
    setTabOrder(m_policy, m_backend);
    setTabOrder(m_backend, m_route);
    setTheme(Theme::light());
    showChoices();
    showTau();
}

TradeoffPanel::~TradeoffPanel()
{
    m_tau->disconnect(this); // the field accepts typed text when it is hidden, after this body
}

void TradeoffPanel::addTau()
{
    auto* grid = new QGridLayout;
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);

    m_tau = new NumberField;
    m_tau->setObjectName(u"tauField"_s);
    m_tau->setAccessibleName(tr("Trade-off τ"));
    m_tau->setRange(limits::kTau.low, limits::kTau.high);
    m_tau->setNumberFormat({.least = 2, .most = 3}, {});
    m_tau->setSingleStep(kFieldStep);
    auto* label = new QLabel(tr("Trade-off τ"));
    label->setBuddy(m_tau);

    m_slider = new JumpSlider(Qt::Horizontal);
    m_slider->setObjectName(u"tauSlider"_s);
    m_slider->setAccessibleName(tr("Trade-off τ from most uncertain first to shortest path"));
    m_slider->setRange(0, kSliderEnd);
    m_slider->setSingleStep(1);
    m_slider->setPageStep(kSliderPage);
    guardWheel(*m_slider);

    m_strip = new TauStrip;
    m_strip->setObjectName(u"tauStrip"_s);
    m_strip->alignWith(m_slider);

    auto* uncertain = new CaptionLabel(tr("Most uncertain first"));
    auto* shortest = new CaptionLabel(tr("Shortest path"));
    shortest->setAlignment(Qt::AlignRight | Qt::AlignTop);

    grid->addWidget(label, 0, 0);
    grid->addWidget(withRemark(m_tau), 0, 1, Qt::AlignRight);
    grid->addWidget(m_slider, 1, 0, 1, 2);
    grid->addWidget(m_strip, 2, 0, 1, 2);
    grid->addWidget(uncertain, 3, 0, Qt::AlignTop);
    grid->addWidget(shortest, 3, 1, Qt::AlignTop);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(grid);
}

void TradeoffPanel::addChoices()
{
    auto* grid = new QGridLayout;
    grid->setVerticalSpacing(1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    m_policy = new PolicyCombo;
    addCombo(m_policy, *grid, 0, 0, 2, u"policyCombo"_s, tr("Policy"));
    m_forecast = new CaptionLabel;
    m_forecast->setObjectName(u"policyForecast"_s);
    m_forecast->setToolTip(PolicyCombo::explanation());
    grid->addWidget(m_forecast, 2, 0, 1, 2);
    grid->setRowMinimumHeight(3, kForecastGap_px);
    m_backend = new QComboBox;
    addCombo(m_backend, *grid, 4, 0, 1, u"solverCombo"_s, tr("Solver"));
    m_route = new QComboBox;
    addCombo(m_route, *grid, 4, 1, 1, u"routeCombo"_s, tr("Route"));
    qobject_cast<QVBoxLayout*>(layout())->addLayout(grid);

    for (const Backend backend : {Backend::Auto, Backend::Exact, Backend::Cbc, Backend::Heuristic})
        offer(*m_backend, static_cast<int>(backend), backendName(backend),
              hasBackend(backend) ? QString()
                                  : tr("This build of Bergwatch does not include this solver."));
    for (const Route route : {Route::Open, Route::Closed})
        offer(*m_route, static_cast<int>(route), routeName(route), {});
}

void TradeoffPanel::connectChoices()
{
    // `activated` is emitted for choices by the user only, also for the present one.
    const auto connectChoice = [this](QComboBox& combo, auto PlannerSettings::*setting,
                                      auto signal) {
        connect(&combo, &QComboBox::activated, this, [this, &combo, setting, signal](int row) {
            using Choice = std::remove_reference_t<decltype(m_settings.*setting)>;
            const auto choice = static_cast<Choice>(combo.itemData(row).toInt());
            if (choice == m_settings.*setting)
                return;
            m_settings.*setting = choice;
            updateEnabled();
            emit(this->*signal)(choice);
        });
    };
    connectChoice(*m_policy, &PlannerSettings::policy, &TradeoffPanel::policyEdited);
    connectChoice(*m_backend, &PlannerSettings::backend, &TradeoffPanel::backendEdited);
    connectChoice(*m_route, &PlannerSettings::route, &TradeoffPanel::routeEdited);
}

void TradeoffPanel::connectTau()
{
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
        if (position != sliderPosition(m_settings.tau))
            editTau(position / 100.0); // the double nearest to the number shown
    });
    connect(m_tau, &NumberField::edited, this, &TradeoffPanel::editTau);
    connect(m_strip, &TauStrip::tauChosen, this, &TradeoffPanel::chooseTau);
    connect(m_slider, &QSlider::sliderReleased, this, &TradeoffPanel::finishTau);
    connect(m_tau, &NumberField::editFinished, this, &TradeoffPanel::finishTau);
    connect(&m_tauRest, &QTimer::timeout, this, &TradeoffPanel::finishTau);
}

void TradeoffPanel::editTau(double tau)
{
    m_settings.tau = tau;
    m_tauEditing = true;
    showTau();
    if (m_slider->isSliderDown())
        m_tauRest.stop();
    else
        m_tauRest.start();
    emit tauEdited(tau);
}

void TradeoffPanel::finishTyping()
{
    m_tau->finishTyping();
    finishTau();
}

void TradeoffPanel::chooseTau(double tau)
{
    finishTau();
    editTau(tau);
    finishTau();
}

void TradeoffPanel::showCurve(const TauCurve& curve)
{
    m_strip->setCurve(curve);
}

void TradeoffPanel::setDetailsShown(bool isShown)
{
    m_result->setDetailsShown(isShown);
}

void TradeoffPanel::stepPlan(int direction)
{
    const std::optional<double> tau = direction > 0 ? m_strip->nextPlan() : m_strip->previousPlan();
    if (tau && m_strip->isEnabled())
        chooseTau(*tau);
}

/** Texts wrap, so the needed height depends on the width, which docks do not consider. */
bool TradeoffPanel::event(QEvent* event)
{
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)
        updateHeight();
    return QWidget::event(event);
}

void TradeoffPanel::updateHeight()
{
    const int height_px = layout()->totalHeightForWidth(width());
    setMinimumHeight(height_px);
    setMaximumHeight(m_isHeightLimited ? height_px : QWIDGETSIZE_MAX);
}

void TradeoffPanel::setHeightLimited(bool isLimited)
{
    m_isHeightLimited = isLimited;
    updateHeight();
}

void TradeoffPanel::finishTau()
{
    m_tauRest.stop();
    if (std::exchange(m_tauEditing, false))
        emit tauEditFinished();
}

void TradeoffPanel::showTau()
{
    m_tau->showValue(m_settings.tau);
    m_slider->setValue(sliderPosition(m_settings.tau));
    m_strip->setTau(m_settings.tau);
}

void TradeoffPanel::setTheme(const Theme& theme)
{
    setCaptionTheme(*this, theme);
    m_forecast->setMinimumHeight(heightOfTwoLines_px(theme.small())); // room for a range
    m_policy->setTheme(theme);
    m_strip->setTheme(theme);
    m_result->setTheme(theme);
}

void TradeoffPanel::showSettings(const PlannerSettings& settings)
{
    PlannerSettings shown = settings;
    // A snapshot from before the edit must not move the slider while it is dragged.
    if (m_tauEditing)
        shown.tau = m_settings.tau;
    if (shown == m_settings)
        return;
    m_settings = shown;
    showTau();
    showChoices();
    m_result->showPlan(m_readout, m_settings.policy);
}

void TradeoffPanel::showChoices()
{
    m_policy->showPolicy(m_settings.policy);
    select(*m_backend, m_settings.backend);
    select(*m_route, m_settings.route);
    updateEnabled();
}

void TradeoffPanel::setInFlight(bool inFlight)
{
    if (inFlight == m_inFlight)
        return;
    m_inFlight = inFlight;
    m_policy->setInFlight(inFlight);
    updateEnabled();
}

void TradeoffPanel::setLookingBack(bool looksBack)
{
    if (looksBack == m_looksBack)
        return;
    m_looksBack = looksBack;
    if (looksBack)
        finishTyping(); // typed text belongs to the newest instant
    updateEnabled();
}

void TradeoffPanel::updateEnabled()
{
    const bool usesTau = traitsOf(m_settings.policy).usesTau;
    const bool usesSolver = traitsOf(m_settings.policy).solves();
    const QString noUse = tr("The chosen policy does not use this.");
    const QString locked = lockedInFlightText();

    const auto set = [](QWidget& input, const QString& reason, const QString& toolTip) {
        input.setEnabled(reason.isEmpty());
        input.setToolTip(reason.isEmpty() ? toolTip : reason);
    };
    const QString tauReason = m_looksBack ? lookingBackText() : usesTau ? QString() : noUse;
    set(*m_slider, tauReason,
        tr("Small: the most uncertain icebergs come first. Large: the path gets short. Arrow keys "
           "change τ by 0.01, Page keys by 0.25."));
    set(*m_tau, tauReason, tr("Trade-off τ from 0 to 100."));
    m_strip->setEnabled(tauReason.isEmpty()); // it has tool tips of its own
    m_policy->setEnabled(!m_looksBack);
    updateForecast();
    set(*m_backend, m_inFlight ? locked : (usesSolver ? QString() : noUse),
        tr("Solver of the plan. Automatic proves small problems optimal and searches in large "
           "ones."));
    set(*m_route, m_inFlight ? locked : (usesTau ? QString() : noUse),
        tr("A one-way plan ends at the last iceberg; a round trip includes the return."));
}

QString TradeoffPanel::lookingBackText()
{
    return tr("Locked while looking back. Choose Back to latest or Continue from here to change "
              "it.");
}

void TradeoffPanel::updateForecast()
{
    m_policy->setToolTip(m_looksBack ? lookingBackText()
                                     : m_policy->currentData(Qt::ToolTipRole).toString());
    m_forecast->setText(m_looksBack ? lookingBackText() : m_policy->summary());
}

void TradeoffPanel::showForecasts(const PolicyForecastList& forecasts)
{
    m_policy->showForecasts(forecasts);
    updateForecast();
}

void TradeoffPanel::showPlan(const PlanReadout& readout)
{
    m_readout = readout;
    m_result->showPlan(readout, m_settings.policy);
}

} // namespace berg
