using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Options that have no meaning with another body than the Moon.</summary>
public sealed class BodyOptionsTests : IDisposable
{
    private const string Place = "--position 0,0,1000000 --time 55289";
    private const string Mercury = $"{Place} --body mercury --renderer native --ldem MERCURY.LBL";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData($"{Place} --body pluto", 1, "--body is 'pluto'; one of moon, mercury, venus, mars, io, europa, ganymede, callisto is")]
    [InlineData($"{Place} --body mercury", 1, "--body mercury needs --renderer native: POV-Ray's patterns are those of the Moon.")]
    [InlineData($"{Place} --body mercury --renderer native", 1, "--body mercury needs --ldem with the label of a model of Mercury.")]
    [InlineData($"{Mercury} --albedo-map x.img", 1, "--body mercury can't be combined with --albedo-map: the known maps are those of")]
    [InlineData($"{Mercury} --hapke-map x.img", 1, "--body mercury can't be combined with --hapke-map")]
    [InlineData(
        "--kepler-set {2.6E6,0,0,0,0,0} --epoch 55289 --time 55289 --body mercury --renderer native --ldem MERCURY.LBL", 1,
        "--body mercury can't be combined with --kepler-set: orbits are computed with the Moon's gravity")]
    [InlineData(Mercury, 2, "MERCURY.LBL: there is no such file")]
    [InlineData(
        $"{Place} --body mars --renderer native --ldem mars.tif", 1,
        "--body mars can't be drawn from mars.tif: rasters that GDAL reads are of the Moon only. Give a PDS3 model whose label has "
            + "TARGET_NAME = MARS")]
    [InlineData($"{Place} --body io --renderer native --ldem /vsizip/io.zip/io.tif", 1, "--body io can't be drawn from /vsizip")]
    [InlineData($"{Place} --body ceres --renderer native --ldem ceres.cub", 1, "--body is 'ceres'; one of moon, mercury,")]
    [InlineData("ldem synthesize --res 4 --seed 1 --body mars --base LDEM_4.LBL", 1, "--base is for models of the Moon only")]
    [InlineData(
        "ldem synthesize --seed 1 --body mars --projection polar-south --map-scale 1000", 1, "--projection is for models of the Moon only")]
    public void Run_OtherBody_RefusesWhatIsTheMoons(string words, int exitCode, string message) =>
        RefusedRun.Check(_folder, words.Split(' '), exitCode, message);
}
