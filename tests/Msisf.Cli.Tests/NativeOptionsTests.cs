using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>The options of the native renderer, given wrongly.</summary>
public sealed class NativeOptionsTests : IDisposable
{
    private const string Fixed = "--fixed-state {55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}";
    private const string Native = $"{Fixed} --renderer native";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]

    // Words and numbers.
    [InlineData($"{Fixed} --renderer blender", 1, "--renderer is 'blender'; one of povray, native is needed")]
    [InlineData($"{Native} --sun big", 1, "--sun is 'big'; one of point, disc is needed")]
    [InlineData($"{Native} --shading flat", 1, "--shading is 'flat'; one of facet, smooth is needed")]
    [InlineData($"{Native} --transfer gamma", 1, "--transfer is 'gamma'; one of srgb, linear is needed")]
    [InlineData($"{Native} --bit-depth 12", 1, "--bit-depth is '12'; one of 8, 16 is needed")]
    [InlineData($"{Native} --lod on", 1, "--lod is 'on'; one of auto, off is needed")]
    [InlineData($"{Native} --lod-error far", 1, "--lod-error")]
    [InlineData($"{Fixed} --lod-error -0.1", 1, "--lod-error is -0.1; its range is 0 to 100")]
    [InlineData($"{Fixed} --lod-error 101", 1, "--lod-error is 101; its range is 0 to 100")]
    [InlineData($"{Fixed} --lod off --lod-error 1", 1, "--lod-error has no meaning with --lod off")]
    [InlineData($"{Native} --layers all --layers-format tif", 1, "--layers-format is 'tif'; one of fits, npy, tiff is needed")]
    [InlineData($"{Native} --layers all --layers-precision half", 1, "--layers-precision is 'half'; one of double, single is needed")]
    [InlineData($"{Native} --layers all --layers-compression rice", 1, "--layers-compression is 'rice'; one of none, gzip is needed")]
    [InlineData($"{Native} --samples 3", 1, "--samples is 3; the samples form a square grid, so a square number is needed: 1 or 4.")]
    [InlineData($"{Native} --samples 2", 1, "a square number is needed: 1 or 4.")]
    [InlineData($"{Native} --samples 255", 1, "a square number is needed: 225 or 256.")]
    [InlineData($"{Native} --samples 0", 1, "--samples is '0'; a square number from 1 to 256 or auto[:ERROR] is needed")]
    [InlineData($"{Native} --samples 257", 1, "--samples is '257'")]
    [InlineData($"{Native} --samples 4.0", 1, "--samples is '4.0'")]
    [InlineData($"{Native} --samples auto:", 1, "the error of auto is ''; levels of 255 in the range 0.05 to 50 are needed")]
    [InlineData($"{Native} --samples auto:0.04", 1, "the error of auto is '0.04'")]
    [InlineData($"{Native} --samples auto:0,5", 1, "the error of auto is '0,5'")]
    [InlineData($"{Native} --samples auto:NaN", 1, "the error of auto is 'NaN'")]
    [InlineData($"{Native} --samples automatic", 1, "--samples is 'automatic'")]
    [InlineData($"{Native} --albedo -0.1", 1, "--albedo")]
    [InlineData($"{Native} --albedo 1.01", 1, "--albedo")]
    [InlineData($"{Native} --albedo bright", 1, "--albedo: 'bright' is not a number")]
    [InlineData($"{Native} --albedo 0,5", 1, "'0,5' has a comma")]
    [InlineData($"{Native} --exposure 0", 1, "--exposure")]
    [InlineData($"{Native} --exposure -1", 1, "--exposure")]
    [InlineData($"{Native} --exposure NaN", 1, "'NaN' is not finite")]

    // Laws.
    [InlineData($"{Native} --reflectance phong", 1, "law 'phong' is not known. Known laws: akimov (parameter mu), hapke (")]
    [InlineData($"{Native} --reflectance lambert:l=1", 1, "law lambert has no parameter 'l'. It has none")]
    [InlineData($"{Native} --reflectance hapke:V=0.3", 1, "law hapke has no parameter 'v'. It has w, b, c, b0, h, theta")]
    [InlineData($"{Native} --reflectance hapke:w", 1, "'w' is not a parameter; name=number is needed")]
    [InlineData($"{Native} --reflectance hapke:", 1, "'' is not a parameter; name=number is needed")]
    [InlineData($"{Native} --reflectance hapke:w=", 1, "'w=' is not a parameter")]
    [InlineData($"{Native} --reflectance hapke:w=0.3,w=0.4", 1, "the parameter w is given twice")]
    [InlineData($"{Native} --reflectance hapke:w=1.5", 1, "--reflectance: ")]
    [InlineData($"{Native} --reflectance hapke:theta=90", 1, "--reflectance: ")]
    [InlineData($"{Native} --reflectance hapke:w=0.3 --albedo 0.2", 1, "has both w and an albedo")]
    [InlineData($"{Native} --reflectance :l=1", 1, "law '' is not known")]
    [InlineData($"{Native} --albedo 0.2", 1, "law moon has the Moon's own brightness and takes no albedo")]
    [InlineData($"{Native} --reflectance nac --albedo 0.2", 1, "law nac has the Moon's own brightness")]
    [InlineData($"{Native} --reflectance moon:w=0.3", 1, "law moon has no parameter 'w'")]

    // Maps and bands.
    [InlineData($"{Native} --band 500", 1, "--band is '500'; one of 321, 360, 415, 566, 604, 643, 689 is needed")]
    [InlineData($"{Native} --albedo-map nowhere/a.img", 2, "nowhere/a.img: there is no such file")]
    [InlineData($"{Native} --reflectance lambert --albedo 0.2 --albedo-map a.img", 1, "both set the brightness")]
    [InlineData($"{Native} --albedo-map a.img --albedo-map-properties scale=0", 1, "scale is 0; a number from 1E-12 to")]
    [InlineData($"{Native} --albedo-map a.img --albedo-map-properties size=3", 1, "'size=3' is not a property of a map")]
    [InlineData($"{Native} --albedo-map a.img --albedo-map-properties scale=1,scale=2", 1, "the property scale is given twice")]
    [InlineData($"{Native} --albedo-map a.img --albedo-map none", 1, "--albedo-map none is given beside a map")]
    [InlineData($"{Native} --albedo-map a.img --albedo-map a.img,factor=2", 1, "a.img is given twice")]
    [InlineData($"{Native} --albedo-map a.img,factor=auto", 1, "factor= scales a map to the coarser one around it, and there is none")]
    [InlineData($"{Native} --albedo-map a.img --albedo-map b.img,factor=0", 1, "factor is a number from 1E-12 to 1E6")]
    [InlineData($"{Native} --albedo-map a.img --albedo-map b.img,colour=2", 1, "'colour=2' is not a property of a map")]
    [InlineData($"{Native} --albedo-map a.img --albedo-map b.img --albedo-map-properties scale=1", 1, "write the properties behind each")]
    [InlineData($"{Native} --albedo-map-checksum 12", 1, "64 hexadecimal digits are needed")]
    [InlineData($"{Native} --hapke-map nowhere.img", 2, "nowhere.img: there is no such file")]
    [InlineData($"{Native} --hapke-map a.img --reflectance lambert", 1, "--hapke-map is for --reflectance moon")]
    [InlineData($"{Native} --hapke-map a.img --band 415", 1, "holds the parameters at 643 nm, but --band is 415")]

    // Layers.
    [InlineData($"{Native} --layers xyzzy", 1, "'xyzzy' is not a layer. Give all, or a list of")]
    [InlineData($"{Native} --layers depht", 1, "'depht' is not a layer: did you mean depth?")]
    [InlineData($"{Native} --layers depth,", 1, "'' is not a layer")]
    [InlineData($"{Native} --layers depth,depth", 1, "depth is there twice")]
    [InlineData($"{Native} --layers all,depth", 1, "'all' is not a layer")]
    [InlineData($"{Native} --layers-format npy", 1, "--layers-format is given, but no --layers")]
    [InlineData($"{Native} --layers-precision single", 1, "--layers-precision is given, but no --layers")]
    [InlineData($"{Native} --layers-compression none", 1, "--layers-compression is given, but no --layers")]
    [InlineData($"{Native} --layers mask --layers-format npy --layers-compression gzip", 1,
        "--layers-compression gzip is for --layers-format fits. Choose one of them")]

    // Options of one renderer with the other.
    [InlineData($"{Fixed} --reflectance hapke", 1, "--reflectance is for --renderer native only")]
    [InlineData($"{Fixed} --albedo-map a.img --albedo-map b.img", 1, "several --albedo-map are drawn by the native renderer only")]
    [InlineData($"{Fixed} --albedo 0.2", 1, "--albedo is for --renderer native only")]
    [InlineData($"{Fixed} --sun disc", 1, "--sun is for --renderer native only")]
    [InlineData($"{Fixed} --samples 4", 1, "--samples is for --renderer native only")]
    [InlineData($"{Fixed} --shading smooth", 1, "--shading is for --renderer native only")]
    [InlineData($"{Fixed} --exposure 2", 1, "--exposure is for --renderer native only")]
    [InlineData($"{Fixed} --transfer linear", 1, "--transfer is for --renderer native only")]
    [InlineData($"{Fixed} --bit-depth 16", 1, "--bit-depth is for --renderer native only")]
    [InlineData($"{Fixed} --layers all", 1, "--layers is for --renderer native only")]
    [InlineData($"{Fixed} --renderer povray --layers-format npy", 1, "--layers-format is for --renderer native only")]
    [InlineData($"{Native} --pov-path /usr/bin", 1, "--pov-path has no meaning with --renderer native")]
    [InlineData($"{Native} --pov-options Antialias=Off", 1, "--pov-options has no meaning with --renderer native")]
    [InlineData($"{Native} --timeout 5", 1, "--timeout has no meaning with --renderer native")]
    [InlineData($"{Native} --list-patterns", 1, "--list-patterns has no meaning with --renderer native")]
    [InlineData($"{Native} --pattern-repos p", 1, "--pattern-repos has no meaning with --renderer native")]
    [InlineData($"{Native} --renderer native", 1, "--renderer is given 2 times. Give it once.")]
    [InlineData("patterns --renderer native", 1, "--renderer")]

    // What only the model or the camera shows.
    [InlineData("--fixed-state {55289,0,0,0,0,0,0,1} --renderer native --ephemeris builtin", 2, "at the Moon's centre")]
    [InlineData($"{Native} --ldem missing.lbl --ephemeris builtin", 2, "missing.lbl")]
    public void Run_WrongNativeOption_EndsWithCodeAndOneLine(string words, int exitCode, string message) =>
        RefusedRun.Check(_folder, words.Split(' '), exitCode, message);

    [RequiresTheory(Part.Ldem4)]
    [InlineData("--fixed-state {55289,1.7E6,0,0,0,0,0,1}", 2, "the camera is inside the Moon: step 1 (MJD 55289) by ")]
    public void Run_CameraInTheGround_IsRefused(string words, int exitCode, string message) => RefusedRun.Check(
        _folder, [.. words.Split(' '), "--renderer", "native", "--ephemeris", "builtin", "--ldem", TestParts.Ldem4Label!], exitCode,
        message);
}
