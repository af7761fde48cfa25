#pragma once

#include "tests/support/window/map_fixture.h"

#include <QImage>

namespace berg::test {

inline const Point kSecond_m(500, 3000);

/** Two UAVs: the second higher and heading west; berg-1 is assigned to it. */
inline Scenario twoUavs()
{
    Scenario scenario = MapFixture::fourIcebergs();
    Uav second = scenario.uavs.front();
    second.id = "uav-2";
    second.name = "West";
    second.position_m = kSecond_m;
    second.heading_deg = 270;
    second.spec.altitude_m = 200;
    second.home_m = Point(500, 2500);
    scenario.uavs.push_back(second);
    scenario.icebergs[0].uav = "uav-2";
    return scenario;
}

/** Returns whether the image has a pixel of exactly that colour in the rectangle. */
inline bool hasColour(const QImage& image, const QRectF& near, const QColor& colour)
{
    const QRect rect = near.toAlignedRect().intersected(image.rect());
    for (int y = rect.top(); y <= rect.bottom(); ++y)
        for (int x = rect.left(); x <= rect.right(); ++x)
            if (image.pixelColor(x, y) == colour)
                return true;
    return false;
}

} // namespace berg::test
