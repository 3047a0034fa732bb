#include <array>
#include <cstdio>

#include "algebroproj/algebroproj.hpp"

int main()
{
    const std::array<double, 3> point = {1.0, 2.0, 4.0};
    const auto image = algebroproj::optics::image_point(2.0, point);
    std::printf("%.17g %.17g %.17g\n", image[0], image[1], image[2]);

    const std::array<double, 3> in_the_lens = {1.0, 2.0, -2.0};
    std::printf("%g\n", algebroproj::optics::image_point(2.0, in_the_lens)[0]);
    return 0;
}
