using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings;
using Msisf.Core.Metadata;
using Xunit;

namespace Msisf.App.Tests.Settings;

/// <summary>A frame's canonical arguments, read as the command line reads them, give the same frame.</summary>
public sealed class FrameArgumentsTests
{
    [Theory]
    [InlineData("", "--fov 40 --width 1024 --height 1024 --gridH 50 --gridV 50 --surface sphere --res 4 --lod-error 0.35 "
        + "--ephemeris cspice --aberration none --renderer povray")]
    [InlineData("--lod off --ignore-sun --grid 10 --gridV 20 --rendering-annotation",
        "--fov 40 --width 1024 --height 1024 --gridH 10 --gridV 20 --surface sphere --res 4 --lod off --ignore-sun "
        + "--rendering-annotation --renderer povray")]
    [InlineData("--renderer native --width 64 --surface terrain --aberration lt+s --layers mask,depth --layers-format npy --bit-depth 16",
        "--fov 40 --width 64 --height 1024 --gridH 50 --gridV 50 --surface terrain --res 4 --lod-error 0.35 --ephemeris cspice "
        + "--aberration lt+s --renderer native --albedo-map none --band 643 --reflectance moon --sun point --samples 1 --shading facet "
        + "--exposure 5 "
        + "--transfer srgb --bit-depth 16 --layers depth,mask --layers-format npy")]
    [InlineData("--renderer native --reflectance lambert --width 64 --layers radiance --band 689",
        "--fov 40 --width 64 --height 1024 --gridH 50 --gridV 50 --surface sphere --res 4 --lod-error 0.35 --ephemeris cspice "
        + "--aberration none --renderer native --band 689 --reflectance lambert --sun point --samples 1 --shading facet --exposure 1 "
        + "--transfer srgb --bit-depth 8 --layers radiance --layers-format fits")]
    [InlineData("--renderer native --reflectance lambert --layers mask --layers-compression gzip --layers-precision single",
        "--fov 40 --width 1024 --height 1024 --gridH 50 --gridV 50 --surface sphere --res 4 --lod-error 0.35 --ephemeris cspice "
        + "--aberration none --renderer native --reflectance lambert --sun point --samples 1 --shading facet --exposure 1 "
        + "--transfer srgb --bit-depth 8 --layers mask --layers-format fits --layers-precision single --layers-compression gzip")]
    [InlineData("--renderer native --reflectance lambert --layers mask --layers-compression none --layers-precision double",
        "--fov 40 --width 1024 --height 1024 --gridH 50 --gridV 50 --surface sphere --res 4 --lod-error 0.35 --ephemeris cspice "
        + "--aberration none --renderer native --reflectance lambert --sun point --samples 1 --shading facet --exposure 1 "
        + "--transfer srgb --bit-depth 8 --layers mask --layers-format fits")]
    [InlineData("--renderer native --reflectance nac",
        "--fov 40 --width 1024 --height 1024 --gridH 50 --gridV 50 --surface sphere --res 4 --lod-error 0.35 --ephemeris cspice "
        + "--aberration none --renderer native --reflectance nac --sun point --samples 1 --shading facet --exposure 5 "
        + "--transfer srgb --bit-depth 8")]
    [InlineData("--renderer native --reflectance hapke:w=0.3,b0=1.2 --samples 9 --sun disc --shading smooth --transfer linear "
        + "--exposure 2.5",
        "--fov 40 --width 1024 --height 1024 --gridH 50 --gridV 50 --surface sphere --res 4 --lod-error 0.35 --ephemeris cspice "
        + "--aberration none --renderer native --reflectance hapke:b0=1.2,w=0.3 --sun disc --samples 9 --shading smooth --exposure 2.5 "
        + "--transfer linear --bit-depth 8")]
    public void OfSettings_ReadAgain_AreTheSame(string given, string expected)
    {
        string canonical = FrameArguments.OfSettings(RenderSettingsReader.Read(Given.Options(given)), EphemerisChoice.CSpice);

        Assert.Equal(expected, canonical);
        Assert.Equal(
            canonical, FrameArguments.OfSettings(RenderSettingsReader.Read(Given.Options(canonical)), EphemerisChoice.CSpice));
    }

    [Fact]
    public void OfSettings_WithAMap_NamesItsFileAndChecksum()
    {
        InputFile map = new(InputKind.AlbedoMap, "a map.img", 7, new string('a', 64));

        string canonical = FrameArguments.OfSettings(
            RenderSettingsReader.Read(Given.Options("--albedo-map maps/a.img --albedo-map-properties scale=2E-05,west=0 --band 415")),
            engine: null,
            map);

        Assert.EndsWith(
            $"--renderer povray --albedo-map 'a map.img' --albedo-map-checksum {map.Sha256} --albedo-map-properties scale=2E-05,west=0 "
                + "--band 415",
            canonical,
            StringComparison.Ordinal);
    }
}
