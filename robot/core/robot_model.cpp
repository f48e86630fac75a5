// SPDX-License-Identifier: MIT
#include "robot/core/robot_model.h"

#include "robot/core/angles.h"

// Sources of the values. "Description" means the vendor's public description files (which cite its articles
// on DH parameters, joint torques and speeds); "assumed" means chosen for this project.
//
// - DH: description files. UR7e has the arm of the UR5e, UR12e that of the UR10e. Like the controller, this
//   file rounds pi/2 to 1.570796327; forward kinematics then agrees with a recorded pose to the last digit.
// - Speeds: the rated values. The controller's ConfigurationData reports 0.2 rad/s more (observed on a UR5e).
// - UR18 and UR8 Long torques and speeds: assumed as UR15, which has the same shoulder and wrists.
// - Dashboard names of UR7e, UR12e and UR8 Long: assumed to be the names in their simulator image.
// - Inertia of UR3, UR3e, UR5, UR5e, UR7e: cylinders, the only published values.
// - Inertia of UR30: assumed. Shoulder and wrists as UR20 (same masses); upper arm and forearm scaled from
//   the UR20 by mass and length, because the public file repeats another robot's values.
// - Torque per current: UR5e and UR7e from a simulated controller (gravity torque divided by reported
//   current). UR10e, UR10, UR12e, UR16e: gains measured on a UR10e. All others assumed: 9.93052 (T/150)^k
//   with T the joint's maximum torque, k = 0.146 below 150 Nm and 0.441 above, fitted to the known joints.

namespace tiller {
namespace {

constexpr double kHalfPi = 1.570796327;  // rounded as in the controller

DhParameters dh(double d1, double a2, double a3, double d4, double d5, double d6) {
    DhParameters result;
    result.a = {0, a2, a3, 0, 0, 0};
    result.d = {d1, 0, 0, d4, d5, d6};
    result.alpha = {kHalfPi, 0, 0, kHalfPi, -kHalfPi, 0};
    return result;
}

using Six = std::array<double, 6>;
using Links = std::array<LinkInertia, 6>;
using Masses = std::array<double, 6>;
using Centres = std::array<std::array<double, 3>, 6>;
using Tensors = std::array<std::array<double, 6>, 6>;

Links links(const Masses& masses, const Centres& centres, const Tensors& tensors) {
    Links result;
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = {masses[i], centres[i], tensors[i]};
    }
    return result;
}

struct Cylinder {
    double across;  // moment of inertia about a diameter
    double along;   // moment of inertia about the cylinder axis
};

// The cylinder axis of shoulder, wrist 1 and wrist 2 is the axis of the preceding joint (y of their DH
// frame). Upper arm and forearm extend along x. Wrist 3 rotates about z.
Tensors cylinders(const std::array<Cylinder, 6>& c) {
    Tensors result;
    for (const std::size_t i : {0U, 3U, 4U}) {
        result[i] = {c[i].across, 0, 0, c[i].along, 0, c[i].across};
    }
    for (const std::size_t i : {1U, 2U}) {
        result[i] = {c[i].along, 0, 0, c[i].across, 0, c[i].across};
    }
    result[5] = {c[5].across, 0, 0, c[5].across, 0, c[5].along};
    return result;
}

constexpr Six joints(double base, double shoulder, double elbow, double wrists) {
    return {base, shoulder, elbow, wrists, wrists, wrists};
}

constexpr Six speeds(double base, double shoulder, double elbow, double wrists) {
    return joints(toRadians(base), toRadians(shoulder), toRadians(elbow), toRadians(wrists));
}

// ---- shared between models --------------------------------------------------------------------

constexpr Centres kCentresUr3 = {
    {{0, -0.02, 0}, {0.13, 0, 0.1157}, {0.05, 0, 0.0238}, {0, 0, 0.01}, {0, 0, 0.01}, {0, 0, -0.02}}};
constexpr Centres kCentresUr5 = {{{0, -0.02561, 0.00193},
                                  {0.2125, 0, 0.11336},
                                  {0.15, 0, 0.0265},
                                  {0, -0.0018, 0.01634},
                                  {0, 0.0018, 0.01634},
                                  {0, 0, -0.001159}}};
constexpr Centres kCentresUr10 = {{{0.021, 0, 0.027},
                                   {0.38, 0, 0.158},
                                   {0.24, 0, 0.068},
                                   {0, 0.007, 0.018},
                                   {0, 0.007, 0.018},
                                   {0, 0, -0.026}}};
constexpr Tensors kTensorsUr10 = {{{0.03408, 0.00002, -0.00425, 0.03529, 0.00008, 0.02156},
                                   {0.02814, 0.00005, -0.01561, 0.77068, 0.00002, 0.76943},
                                   {0.01014, 0.00008, 0.00916, 0.30928, 0, 0.30646},
                                   {0.00296, -0.00001, 0, 0.00222, -0.00024, 0.00258},
                                   {0.00296, -0.00001, 0, 0.00222, -0.00024, 0.00258},
                                   {0.0004, 0, 0, 0.00041, 0, 0.00034}}};

// UR8 Long, UR15 and UR18 differ only in the upper arm and forearm.
struct LongLinks {
    double upperMass;
    double foreMass;
    std::array<double, 3> upperCentre;
    std::array<double, 3> foreCentre;
    Six upperTensor;
    Six foreTensor;
};

Links linksUr15Family(const LongLinks& own) {
    return links({9.9883, own.upperMass, own.foreMass, 2.089, 2.0869, 1.0666},
                 {{{0.000024, -0.033309, 0.025304},
                   own.upperCentre,
                   own.foreCentre,
                   {0.000025, -0.019695, 0.016413},
                   {0.000025, 0.01996, 0.015886},
                   {-0.000018, -0.000112, -0.053397}}},
                 {{{0.051334, 0.000025, -0.000016, 0.047702, 0.008805, 0.034263},
                   own.upperTensor,
                   own.foreTensor,
                   {0.004339, 0.000019, 0.000001, 0.002548, 0.000706, 0.003912},
                   {0.004288, 0.000017, -0.000003, 0.002566, -0.000716, 0.003927},
                   {0.001406, -0.000003, 0.00001, 0.001404, -0.000024, 0.001002}}});
}

constexpr Six kShoulderUr20 = {0.08866, -0.00011, -0.00011, 0.07632, 0.0072, 0.08418};
constexpr Six kUpperUr20 = {0.1467, 0.00019, -0.05163, 4.6659, 0.00004, 4.6348};
constexpr Six kForeUr20 = {0.02612, -0.00005, -0.02898, 0.75763, -0.00001, 0.75327};
constexpr Six kWrist1Ur20 = {0.00555, -0.00001, -0.00002, 0.00537, 0.00036, 0.00402};
constexpr Six kWrist2Ur20 = {0.00586, -0.00001, -0.00002, 0.00578, -0.00037, 0.00427};
constexpr Six kWrist3Ur20 = {0.00092, 0, 0, 0.00091, 0, 0.00117};

// Shortens a tube along x. The cross-section is unchanged, so only the length-dependent terms are scaled.
constexpr Six shortened(const Six& tensor, double massRatio, double lengthRatio) {
    return {tensor[0] * massRatio,
            tensor[1] * massRatio * lengthRatio,
            tensor[2] * massRatio * lengthRatio,
            tensor[3] * massRatio * lengthRatio * lengthRatio,
            tensor[4] * massRatio,
            tensor[5] * massRatio * lengthRatio * lengthRatio};
}

constexpr Six kTorquePerCurrentUr5e = joints(9.93052, 9.93052, 9.93052, 7.77195);
constexpr Six kTorquePerCurrentUr10e = {14.87, 13.26, 11.13, 10.62, 11.03, 11.47};
constexpr Six kTorquePerCurrentUr15 = joints(15.85, 15.85, 11.37, 8.88);
constexpr Six kTorquePerCurrentUr20 = joints(20.04, 20.04, 15.85, 9.45);

// ---- the models -------------------------------------------------------------------------------

std::array<RobotModel, 14> makeModels() {
    using Id = RobotModelId;
    const Six speedsSmall = speeds(180, 180, 180, 360);
    const Six speedsUr5 = speeds(180, 180, 180, 180);
    const Six speedsUr10 = speeds(120, 120, 180, 180);
    const Six speedsUr15 = speeds(180, 180, 240, 300);
    const Six speedsUr20 = speeds(120, 120, 150, 210);
    const Six torquesUr5 = joints(150, 150, 150, 28);
    const Six torquesUr10e = joints(330, 330, 150, 54);
    const Six torquesUr15 = joints(433, 433, 204, 70);
    const Six torquesUr20 = joints(738, 738, 433, 107);

    const DhParameters dhUr5e = dh(0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996);
    const DhParameters dhUr10e = dh(0.1807, -0.6127, -0.57155, 0.17415, 0.11985, 0.11655);

    const Links linksUr3 = links({2.0, 3.42, 1.26, 0.8, 0.8, 0.35}, kCentresUr3,
                                 cylinders({{{0.0080932, 0.005625},
                                             {0.0217285, 0.0096188},
                                             {0.0065468, 0.0035438},
                                             {0.0016106, 0.00225},
                                             {0.0015722, 0.00225},
                                             {0.00013627, 0.0001792}}}));
    const Links linksUr3e = links({1.98, 3.4445, 1.437, 0.871, 0.805, 0.261}, kCentresUr3,
                                  cylinders({{{0.0080932, 0.005625},
                                              {0.0217285, 0.0096188},
                                              {0.0065446, 0.0035438},
                                              {0.002085, 0.00225},
                                              {0.002085, 0.00225},
                                              {0.00013627, 0.0001792}}}));
    const Links linksUr5 = links({3.7, 8.393, 2.33, 1.219, 1.219, 0.1879}, kCentresUr5,
                                 cylinders({{{0.0149724, 0.0104063},
                                             {0.1338858, 0.0151074},
                                             {0.0312168, 0.004095},
                                             {0.0020139, 0.0021942},
                                             {0.001831, 0.0021942},
                                             {0.0000806, 0.0001321}}}));
    const Links linksUr5e = links({3.761, 8.058, 2.846, 1.37, 1.3, 0.365}, kCentresUr5,
                                  cylinders({{{0.0102675, 0.00666},
                                              {0.1338858, 0.0151074},
                                              {0.0312094, 0.004095},
                                              {0.0025599, 0.0021942},
                                              {0.0025599, 0.0021942},
                                              {0.0000989, 0.0001321}}}));
    const Links linksUr10 = links({7.1, 12.7, 4.27, 2.0, 2.0, 0.365}, kCentresUr10, kTensorsUr10);
    const Links linksUr10e = links({7.369, 13.051, 3.989, 2.1, 1.98, 0.615}, kCentresUr10, kTensorsUr10);
    const Links linksUr16e = links({7.369, 10.45, 4.321, 2.18, 2.033, 0.907},
                                   {{{0, -0.016, 0.03},
                                     {0.302, 0, 0.16},
                                     {0.194, 0, 0.065},
                                     {0, -0.009, 0.011},
                                     {0, 0.018, 0.012},
                                     {0, 0, -0.044}}},
                                   {{{0.03351, 0.00002, -0.00001, 0.03374, 0.00374, 0.021},
                                     {0.02796, -0.0001, -0.0072, 0.47558, 0.00003, 0.47635},
                                     {0.01091, 0.00006, 0.01012, 0.1206, 0.00001, 0.11714},
                                     {0.00609, -0.00001, 0, 0.00245, 0.00083, 0.00579},
                                     {0.00389, -0.00001, 0, 0.00219, -0.00045, 0.00363},
                                     {0.00117, 0, 0, 0.00118, 0, 0.00084}}});
    const Links linksUr8Long =
        linksUr15Family({17.0738,
                         7.6393,
                         {0.565429, -0.000074, 0.19542},
                         {0.416102, 0.000058, 0.065663},
                         {0.056709, 0.000292, -0.054852, 2.44012, -0.000014, 2.432744},
                         {0.022148, 0.000052, 0.019779, 0.633274, 0.000003, 0.625889}});
    const Links linksUr15 = linksUr15Family({14.9255,
                                             6.1015,
                                             {0.419009, -0.000083, 0.192787},
                                             {0.305471, 0.000019, 0.070552},
                                             {0.048202, 0.000232, -0.032135, 1.188499, -0.000017, 1.182771},
                                             {0.018481, -0.000005, 0.013601, 0.303502, 0.000003, 0.296843}});
    const Links linksUr18 = linksUr15Family({14.2009,
                                             5.52,
                                             {0.308664, -0.000088, 0.190204},
                                             {0.199652, 0.000021, 0.073101},
                                             {0.045094, 0.000179, -0.024705, 0.630805, -0.00002, 0.625724},
                                             {0.016891, 0, 0.009081, 0.129732, 0.000003, 0.123451}});
    const Links linksUr20 =
        links({16.343, 29.632, 7.879, 3.054, 3.126, 0.926},
              {{{0, -0.061, 0.0062},
                {0.5226, 0, 0.2098},
                {0.3234, 0, 0.0604},
                {0, -0.0026, 0.0393},
                {0, 0.0024, 0.0379},
                {0, 0, -0.0293}}},
              {{kShoulderUr20, kUpperUr20, kForeUr20, kWrist1Ur20, kWrist2Ur20, kWrist3Ur20}});
    const Links linksUr30 = links(
        {16.343, 28.542, 7.156, 3.054, 3.126, 0.926},
        {{{-0.0001, -0.06, 0.0069},
          {0.3894, 0, 0.2103},
          {0.2257, 0, 0.0629},
          {0, -0.0048, 0.0353},
          {0, 0.0046, 0.0341},
          {0, 0, -0.0293}}},
        {{kShoulderUr20, shortened(kUpperUr20, 28.542 / 29.632, 0.637 / 0.862),
          shortened(kForeUr20, 7.156 / 7.879, 0.5037 / 0.7287), kWrist1Ur20, kWrist2Ur20, kWrist3Ur20}});

    return {{
        {Id::UR3, "UR3", "UR3", 3, 0.5, 3.0, dh(0.1519, -0.24365, -0.21325, 0.11235, 0.08535, 0.0819),
         speedsSmall, joints(56, 56, 28, 12), joints(8.6, 8.6, 7.77195, 6.87), linksUr3},
        {Id::UR5, "UR5", "UR5", 1, 0.85, 5.0, dh(0.089159, -0.425, -0.39225, 0.10915, 0.09465, 0.0823),
         speedsUr5, torquesUr5, kTorquePerCurrentUr5e, linksUr5},
        {Id::UR10, "UR10", "UR10", 2, 1.3, 10.0, dh(0.1273, -0.612, -0.5723, 0.163941, 0.1157, 0.0922),
         speedsUr10, joints(330, 330, 150, 56), kTorquePerCurrentUr10e, linksUr10},
        {Id::UR3e, "UR3e", "UR3", 3, 0.5, 3.0, dh(0.15185, -0.24355, -0.2132, 0.13105, 0.08535, 0.0921),
         speedsSmall, joints(54, 54, 28, 9), joints(8.55, 8.55, 7.77195, 6.58), linksUr3e},
        {Id::UR5e, "UR5e", "UR5", 1, 0.85, 5.0, dhUr5e, speedsUr5, torquesUr5, kTorquePerCurrentUr5e,
         linksUr5e},
        {Id::UR7e, "UR7e", "UR7", 1, 0.85, 7.5, dhUr5e, speedsUr5, torquesUr5, kTorquePerCurrentUr5e,
         linksUr5e},
        {Id::UR10e, "UR10e", "UR10", 2, 1.3, 12.5, dhUr10e, speedsUr10, torquesUr10e, kTorquePerCurrentUr10e,
         linksUr10e},
        {Id::UR12e, "UR12e", "UR12", 2, 1.3, 12.5, dhUr10e, speedsUr10, torquesUr10e, kTorquePerCurrentUr10e,
         linksUr10e},
        {Id::UR16e, "UR16e", "UR16", 4, 0.9, 16.0, dh(0.1807, -0.4784, -0.36, 0.17415, 0.11985, 0.11655),
         speedsUr10, torquesUr10e, kTorquePerCurrentUr10e, linksUr16e},
        {Id::UR8Long, "UR8Long", "UR8LONG", 6, 1.75, 8.0,
         dh(0.2186, -0.8989, -0.7149, 0.1824, 0.1361, 0.1434), speedsUr15, torquesUr15, kTorquePerCurrentUr15,
         linksUr8Long},
        {Id::UR15, "UR15", "UR15", 9, 1.3, 15.0, dh(0.2186, -0.6475, -0.5164, 0.1824, 0.1361, 0.1434),
         speedsUr15, torquesUr15, kTorquePerCurrentUr15, linksUr15},
        {Id::UR18, "UR18", "UR18", 5, 0.95, 18.0, dh(0.2186, -0.475, -0.3389, 0.1824, 0.1361, 0.1434),
         speedsUr15, torquesUr15, kTorquePerCurrentUr15, linksUr18},
        {Id::UR20, "UR20", "UR20", 7, 1.75, 20.0, dh(0.2363, -0.862, -0.7287, 0.201, 0.1593, 0.1543),
         speedsUr20, torquesUr20, kTorquePerCurrentUr20, linksUr20},
        {Id::UR30, "UR30", "UR30", 8, 1.3, 30.0, dh(0.2363, -0.637, -0.5037, 0.201, 0.1593, 0.1543),
         speedsUr20, torquesUr20, kTorquePerCurrentUr20, linksUr30},
    }};
}

const std::array<RobotModel, 14>& models() {
    static const std::array<RobotModel, 14> all = makeModels();
    return all;
}

}  // namespace

const RobotModel& robotModel(RobotModelId id) {
    return models()[static_cast<std::size_t>(id)];
}

std::span<const RobotModel> robotModels() {
    return models();
}

std::optional<RobotModelId> robotModelByName(const Text& name) {
    const QString wanted = QString(name).remove(QLatin1Char(' '));
    for (const RobotModel& model : models()) {
        if (wanted.compare(QLatin1String(model.name), Qt::CaseInsensitive) == 0) {
            return model.id;
        }
    }
    return std::nullopt;
}

std::optional<RobotModelId> robotModelByType(int robotType, bool isCb3) {
    for (const RobotModel& model : models()) {
        if (model.robotType == robotType && model.isCb3() == isCb3) {
            return model.id;
        }
    }
    return std::nullopt;
}

}  // namespace tiller
