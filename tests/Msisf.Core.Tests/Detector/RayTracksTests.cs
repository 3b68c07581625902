using Msisf.Core.Detector;
using Msisf.Core.Detector.Noise;
using Xunit;

namespace Msisf.Core.Tests.Detector;

public sealed class RayTracksTests
{
    private static readonly DetectorSettings Settings = new()
    {
        ApertureArea = 1.0,
        Response = new SpectralResponse(500.0, 600.0, new SpectralCurve(1.0), new SpectralCurve(1.0)),
        ExposureTime = 100.0,
        Gain = 1.0,
        ConverterBits = 16,
        PixelPitch = 1e-5,
        Seed = 1,
        CosmicRays = new CosmicRays { Rate = 10.0 },
    };

    [Fact]
    public void Add_LongExposure_LeavesTheElectronsOfAnIsotropicFlux()
    {
        // 512 x 512 px of 10 micrometres are 0.262 cm^2: 262 rays of 800 electrons over the cosine. The mean of 1 / cosine of an isotropic
        // flux is 2; tracks are cut at the borders, and a few long ones dominate, so the bounds are wide.
        double[] charge = new double[512 * 512];
        RayTracks.Add(charge, 512, Settings, NoiseSource.OfFrame(4, 5));
        int hit = charge.Count(electrons => electrons > 0.0);
        Assert.InRange(charge.Sum(), 262.0 * 1200.0, 262.0 * 2000.0);
        Assert.InRange(hit, 400, 2000);
        Assert.All(charge, electrons => Assert.Equal(Math.Floor(electrons), electrons));
    }

    [Fact]
    public void Add_OtherFrame_HitsElsewhere()
    {
        double[] first = new double[512 * 512];
        double[] second = new double[512 * 512];
        RayTracks.Add(first, 512, Settings, NoiseSource.OfFrame(4, 5));
        RayTracks.Add(second, 512, Settings, NoiseSource.OfFrame(4, 6));
        Assert.InRange(first.Zip(second).Count(pair => pair.First > 0.0 && pair.Second > 0.0), 0, 20);
    }
}
