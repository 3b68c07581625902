using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Xunit;

namespace Msisf.Core.Tests.Camera.Lenses;

public sealed class DistortionTests
{
    /// <summary>Parts of the focal length: some units in the last place of 1.</summary>
    private const double Rounding = 1e-15;

    /// <summary>px.</summary>
    private const double Focal = 1000.0;

    // python3 tests/reference/distortion.py
    [Theory]
    [InlineData("opencv", 0.3, -0.2, 0.29267696514086082743, -0.19506844676057388495)]
    [InlineData("opencv", -0.55, 0.4, -0.5134635279567889899, 0.3736261069799374472)]
    [InlineData("opencv", 0.01, 0.002, 0.0099994391982044768683, 0.0020000126482936953737)]
    [InlineData("opencv", 0.7, 0.65, 0.60720784129491005774, 0.56656512383634505361)]
    [InlineData("fisheye", 0.3, -0.2, 0.28859786912009728192, -0.19239857941339818794)]
    [InlineData("fisheye", -0.55, 0.4, -0.48615760972365158137, 0.353569170708110241)]
    [InlineData("fisheye", 0.01, 0.002, 0.0099996741522600414411, 0.0019999348304520082882)]
    [InlineData("fisheye", 0.7, 0.65, 0.5644157793132033521, 0.52410036650511739838)]
    [InlineData("owen", 0.3, -0.2, 0.29773015989214169253, -0.1982899101617874612)]
    [InlineData("owen", -0.55, 0.4, -0.53789342223958631457, 0.39009434715494381747)]
    [InlineData("owen", 0.01, 0.002, 0.0099997875985979613936, 0.0020000636013858730322)]
    [InlineData("owen", 0.7, 0.65, 0.66086483090041228916, 0.61717798859763291937)]
    [InlineData("radial-factor", 0.3, -0.2, 0.31716829015598171227, -0.21144552677065447485)]
    [InlineData("radial-factor", -0.55, 0.4, -0.68992767102251656783, 0.50176557892546659479)]
    [InlineData("radial-factor", 0.01, 0.002, 0.010000427870859439124, 0.0020000855741718878247)]
    [InlineData("radial-factor", 0.7, 0.65, 1.199240260321743228, 1.1135802417273329974)]
    [InlineData("radial-division", 0.3, -0.2, 0.29965488191576544442, -0.19976992127717696295)]
    [InlineData("radial-division", -0.55, 0.4, -0.54775559325522320729, 0.39836770418561687803)]
    [InlineData("radial-division", 0.01, 0.002, 0.0099999907862601391224, 0.0019999981572520278245)]
    [InlineData("radial-division", 0.7, 0.65, 0.69438645612131053624, 0.64478742354121692651)]
    [InlineData("brown", 0.3, -0.2, 0.30368109590421060625, -0.20295343280614654531)]
    [InlineData("brown", -0.55, 0.4, -0.53947010827461395, 0.38993864478813015469)]
    [InlineData("brown", 0.01, 0.002, 0.01000197720746236, 0.0020493069723798001611)]
    [InlineData("brown", 0.7, 0.65, 0.67415331035053020625, 0.61386244733894362344)]
    [InlineData("polynomial-radius", 0.3, -0.2, 0.29959284985248570175, -0.20114749661563592451)]
    [InlineData("polynomial-radius", -0.55, 0.4, -0.55130172849355272331, 0.39926638046426658105)]
    [InlineData("polynomial-radius", 0.01, 0.002, 0.00972524949956379483, 0.0010238892059705358702)]
    [InlineData("polynomial-radius", 0.7, 0.65, 0.69683290264347477078, 0.65035911050414378488)]
    [InlineData("polynomial-x", 0.3, -0.2, 0.29965747389818450656, -0.20115166973990422705)]
    [InlineData("polynomial-x", -0.55, 0.4, -0.54986527825708424344, 0.39943817306747389795)]
    [InlineData("polynomial-x", 0.01, 0.002, 0.0097252247341529565562, 0.0010240806742516979469)]
    [InlineData("polynomial-x", 0.7, 0.65, 0.69860284332838450656, 0.64931927163239577295)]
    public void BothWays_PublishedFormula_AgreesTo50Digits(string model, double x, double y, double expectedX, double expectedY)
    {
        CameraModel camera = Camera(model);
        bool isFromIdeal = model is "opencv" or "fisheye" or "owen";
        (double X, double Y) ideal = isFromIdeal ? (x, y) : (expectedX, expectedY);
        (double X, double Y) measured = isFromIdeal ? (expectedX, expectedY) : (x, y);

        Assert.True(camera.TryToImage(ideal.X, ideal.Y, out RenderingPoint seen));
        (double right, double down) = camera.ToIdeal(camera.PrincipalX + (Focal * measured.X), camera.PrincipalY + (Focal * measured.Y));

        Assert.Equal(measured.X, (seen.X - camera.PrincipalX) / Focal, Rounding);
        Assert.Equal(measured.Y, (seen.Y - camera.PrincipalY) / Focal, Rounding);
        Assert.Equal(ideal.X, right, Rounding);
        Assert.Equal(ideal.Y, down, Rounding);
    }

    /// <summary>The slopes turn the illumination direction and choose the level of detail.</summary>
    [Theory]
    [InlineData("opencv")]
    [InlineData("fisheye")]
    [InlineData("owen")]
    [InlineData("radial-factor")]
    [InlineData("radial-division")]
    [InlineData("brown")]
    [InlineData("polynomial-radius")]
    [InlineData("polynomial-x")]
    public void Apply_Slopes_AreThoseOfTheFormula(string model)
    {
        const double Step = 1e-6;
        Distortion formula = Camera(model).Distortion!;
        Random random = new(2);
        for (int i = 0; i < 50; i++)
        {
            (double x, double y) = (random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            formula.Apply(LanePoints.All(x, y), out LaneSlopes slopes);
            LanePoints right = formula.Apply(LanePoints.All(x + Step, y), out _);
            LanePoints left = formula.Apply(LanePoints.All(x - Step, y), out _);
            LanePoints below = formula.Apply(LanePoints.All(x, y + Step), out _);
            LanePoints above = formula.Apply(LanePoints.All(x, y - Step), out _);
            AssertSlope(right.X, left.X, slopes.Xx);
            AssertSlope(right.Y, left.Y, slopes.Yx);
            AssertSlope(below.X, above.X, slopes.Xy);
            AssertSlope(below.Y, above.Y, slopes.Yy);
        }

        static void AssertSlope(Vector512<double> after, Vector512<double> before, Vector512<double> slope) =>
            // rounding over the step of the difference, and its square
            Assert.Equal((after[0] - before[0]) / (2.0 * Step), slope[0], 1e-8);
    }

    /// <summary>A point gets the same bits alone and among others: images do not depend on how pixels are put together.</summary>
    [Theory]
    [InlineData("opencv")]
    [InlineData("fisheye")]
    [InlineData("polynomial-radius")]
    public void ToIdeal_EightPoints_HaveTheBitsOfEach(string model)
    {
        CameraModel camera = Camera(model);
        double[] x = [1.0, 300.5, 700.5, 701.0, 701.25, 777.0, 1333.0, 1400.0];
        LanePoints eight = camera.ToIdeal(Vector512.Create<double>(x), Vector512.Create(123.0));
        for (int lane = 0; lane < x.Length; lane++)
        {
            Assert.Equal(camera.ToIdeal(x[lane], 123.0), (eight.X[lane], eight.Y[lane]));
        }
    }

    private static CameraModel Camera(string model) => new(1400, 1300, (Focal, Focal), (700.5, 650.5), 0.0, model switch
    {
        "opencv" => new OpenCvDistortion(
            [-0.15, 0.04, -0.005, 0.02, 0.01, 0.002], [0.003, -0.002], [0.001, -0.0005, -0.002, 0.0007]),
        "fisheye" => new FisheyeDistortion([0.02, -0.005, 0.001, -0.0002]),
        "owen" => new OwenDistortion([1e-4, -5e-4, 2e-6, -1e-6, 3e-4, -2e-4], 10.0),
        "radial-factor" => new RadialDistortion(
            [0.0113109452166359, 0.000144463288593614, 4.88754251291127e-6], isDivision: false, 6.0308669),
        "radial-division" => new RadialDistortion([1.81e-8], isDivision: true, 699.62),
        "brown" => new BrownDistortion(
            [3e-3, 2e-5, -4e-8, 5e-12], [1e-4, -2e-4], [3e-5, -1e-8, -2e-5, 2e-8], (0.4, -0.7), 40.0),
        _ => new PolynomialDistortion(
            [-0.02, 1.3e-4, -2.7e-6, -6.2e-7], [-0.07, -9.8e-4, 8.6e-6, 3.7e-7], isRadial: model == "polynomial-radius", 72.45),
    });
}
