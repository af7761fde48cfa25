#include "widgets/words/source_text.h"

#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

namespace berg {
namespace {

struct SourceText
{
    Q_DECLARE_TR_FUNCTIONS(SourceText)
};

} // namespace

QString sourceName(SightingSource source)
{
    switch (source) {
    case SightingSource::Radar:
        return SourceText::tr("ship's radar");
    case SightingSource::Visual:
        return SourceText::tr("eye");
    case SightingSource::Satellite:
        return SourceText::tr("satellite");
    case SightingSource::Camera:
        return SourceText::tr("camera of a UAV");
    case SightingSource::GpsBeacon:
        return SourceText::tr("GPS beacon");
    case SightingSource::ArgosBeacon:
        return SourceText::tr("Argos beacon");
    case SightingSource::Ais:
        return SourceText::tr("AIS");
    case SightingSource::Aircraft:
        return SourceText::tr("aircraft");
    }
    return {};
}

QString sourceText(SightingSource source, const QLocale& locale)
{
    return SourceText::tr("%1, 95 % within %2")
        .arg(sourceName(source), radius95Text(errorOf(source).sigma_m2(), locale));
}

} // namespace berg
