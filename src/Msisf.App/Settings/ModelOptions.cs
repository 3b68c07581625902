using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>The options of the commands that work on elevation models.</summary>
internal static class ModelOptions
{
    public static WholeNumberSpec NewResolution { get; } = SurfaceOptions.Resolution with
    {
        Help = "Resolution of the new model; required for one of latitude and longitude",
        Default = null,
    };

    public static ChoiceSpec<SyntheticProjection> Projection { get; } = new(
        "--projection", DecidesBytes.OfNoFrame,
        [
            new Choice("cylindrical", SyntheticProjection.Cylindrical), new Choice("polar-south", SyntheticProjection.PolarSouth),
            new Choice("polar-north", SyntheticProjection.PolarNorth),
        ],
        "A model of latitude and longitude, or a polar stereographic map around a pole, as LOLA's LDEM_80S_20M")
    {
        Default = SyntheticProjection.Cylindrical,
    };

    public static NumberSpec MapScale { get; } = new(
        "--map-scale", DecidesBytes.OfNoFrame, "METRES", "Width of a pixel of a polar map; required for one")
    {
        Limits = new NumberRange(PolarLabel.MinScale, PolarLabel.MaxScale),
    };

    public static NumberSpec Latitude { get; } = new(
        "--latitude", DecidesBytes.OfNoFrame,
        "DEGREES", "Latitude, north or south, to which a polar map reaches in the middle of its sides")
    {
        Default = SyntheticMapWriter.LowestLatitudeWithBase,
        Limits = new NumberRange(SyntheticMapWriter.LowestLatitude, 90.0) { ExcludesMax = true },
    };

    public static TextSpec Seed { get; } = new(
        "--seed", DecidesBytes.OfNoFrame, "N", "Number that the terrain is drawn from; the same number gives the same bytes")
    {
        IsRequired = true,
    };

    public static ChoiceSpec<int> NewBody { get; } = SurfaceOptions.Body with
    {
        Help = "Body of the new model; that of another one than the Moon has the Moon's terrain, as many degrees wide",
    };

    public static PathSpec Base { get; } = new(
        "--base", DecidesBytes.OfNoFrame, PathKind.File, "Model that the new one continues to smaller scales: its label or image")
    {
        DefaultNote = "none, an invented Moon",
    };

    public static TextSpec Region { get; } = new(
        "--region", DecidesBytes.OfNoFrame,
        "latmin:latmax:lonmin:lonmax",
        "Part of the Moon that gets the detail, in whole degrees; over the prime meridian as in 350:10")
    {
        DefaultNote = "all of it",
    };

    public static ChoiceSpec<SyntheticRest> Rest { get; } = new(
        "--rest", DecidesBytes.OfNoFrame,
        [new Choice("base", SyntheticRest.Base), new Choice("flat", SyntheticRest.Flat), new Choice("none", SyntheticRest.None)],
        "Around the region: the base, interpolated; the reference sphere, which takes no room on the disk; or nothing, a part that "
            + "can't be drawn alone")
    {
        Default = SyntheticRest.Base,
    };

    public static ChoiceSpec<LdemSampleType> SampleType { get; } = new(
        "--sample-type", DecidesBytes.OfNoFrame,
        [new Choice("int16", LdemSampleType.Int16LittleEndian), new Choice("float32", LdemSampleType.Float32LittleEndian)],
        "Samples in 16-bit steps of 0.5 m, or in 32-bit floats")
    {
        DefaultNote = Invariant($"int16; float32 from {SyntheticLdemOptions.FirstResolutionOfFloats} px/deg on"),
    };

    public static PathSpec NewFolder { get; } = OutputOptions.Folder with
    {
        Help = "Folder of the new model",
        Default = "input/ldem",
        DefaultNote = "./input/ldem",
    };

    /// <summary>The model whose coarser levels are made.</summary>
    public static ArgumentSpec Model { get; } = new("MODEL", "The model: its label or image, or with --res the folder that it lies in")
    {
        IsOptional = true,
    };

    public static WholeNumberSpec ModelResolution { get; } = SurfaceOptions.Resolution with
    {
        Help = "Resolution of the model; needed for a folder",
        Default = null,
    };

    public static FlagSpec Verify { get; } = new(
        "--verify", OptionRole.HowItRuns, "Make nothing; read the model and its pyramid and compare them")
    {
        IsOfOneCall = true,
    };

    /// <summary>Reads the options of msis ldem synthesize.</summary>
    /// <exception cref="UsageException">A value is wrong, or options don't go together.</exception>
    public static SynthesisSettings ReadSynthesis(OptionValues values)
    {
        if (values.IsGiven(Rest) && values.Text(Region) is null)
        {
            throw Rest.Wrong($"says what lies around a {Region.Name}. Give one, or leave it out.");
        }

        int? resolution = NewResolution.ReadIfGiven(values);
        SyntheticMapSettings? map = ReadMap(values);
        CelestialBody body = CelestialBody.Of(NewBody.Read(values));
        values.Refuse(
            body.IsMoon ? [] : [Base, Projection], $"is for models of the Moon only. Leave it out, or {NewBody.Name}.", NewBody);

        return new SynthesisSettings(
            map is null
                ? resolution
                    ?? throw NewResolution.Wrong("is required: how many samples a degree?")
                : 0,
            ulong.TryParse(values.Text(Seed), NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
                ? seed
                : throw Seed.Wrong($"is '{values.Text(Seed)}'; a whole number from 0 to {ulong.MaxValue} is needed."),
            Base.ReadIfGiven(values),
            Region.ReadIfGiven(values) is { } region ? Region.NamedInErrors(() => MoonRegion.Parse(region)) : MoonRegion.WholeMoon,
            Rest.Read(values),
            SampleType.ReadIfGiven(values),
            NewFolder.Read(values),
            RunOptions.Batch.Read(values))
        {
            Map = map,
            Body = body,
        };
    }

    private static SyntheticMapSettings? ReadMap(OptionValues values)
    {
        double? scale = MapScale.ReadIfGiven(values);
        double latitude = Latitude.Read(values);
        SyntheticProjection projection = Projection.Read(values);
        bool isMap = projection != SyntheticProjection.Cylindrical;
        values.Refuse(
            isMap ? [NewResolution, Region, Rest] : [MapScale, Latitude],
            isMap
                ? $"is for models of latitude and longitude. Leave it out, or {Projection.Name}."
                : $"is for polar maps. Add {Projection.Name} polar-south or polar-north, or leave it out.",
            Projection);

        return !isMap ? null : new SyntheticMapSettings(
            projection == SyntheticProjection.PolarSouth,
            scale ?? throw MapScale.Wrong("is required for a polar map: how many m is a pixel wide?"),
            latitude);
    }

    /// <summary>Reads the options of msis ldem pyramid.</summary>
    public static PyramidSettings ReadPyramid(OptionValues values) =>
        new(values.Argument, ModelResolution.ReadIfGiven(values), RunOptions.Batch.Read(values));
}

/// <summary>Selects the elevation model whose coarser levels are made or checked.</summary>
/// <param name="Model">Label, image or folder of the model; null for the default folders.</param>
/// <param name="PixelsPerDegree">
/// Resolution of the model, px/deg, needed for a folder; null if <paramref name="Model"/> determines it.
/// </param>
/// <param name="Unattended">Whether to draw no progress bar.</param>
internal sealed record PyramidSettings(string? Model, int? PixelsPerDegree, bool Unattended);

/// <summary>Describes the synthetic elevation model to make.</summary>
/// <param name="PixelsPerDegree">Resolution of a model of latitude and longitude, px/deg; 0 for a polar map.</param>
/// <param name="Seed">Seed of the random terrain.</param>
/// <param name="BaseModel">Label or image of the model that it continues to smaller scales; null for an invented Moon.</param>
/// <param name="Region">Part of the Moon that gets the detail.</param>
/// <param name="Rest">What lies outside the region.</param>
/// <param name="SampleType">How samples are stored; null for the default of the resolution.</param>
/// <param name="Unattended">Whether to draw no progress bar.</param>
internal sealed record SynthesisSettings(
    int PixelsPerDegree,
    ulong Seed,
    string? BaseModel,
    MoonRegion Region,
    SyntheticRest Rest,
    LdemSampleType? SampleType,
    string Folder,
    bool Unattended)
{
    /// <summary>The polar map to make; null for a model of latitude and longitude.</summary>
    public SyntheticMapSettings? Map { get; init; }

    public CelestialBody Body { get; init; } = CelestialBody.Moon;
}

/// <summary>Describes a synthetic polar map to make.</summary>
/// <param name="IsSouth">Whether it is of the south pole.</param>
/// <param name="MetresPerPixel">Map scale, m.</param>
/// <param name="LatitudeDegrees">Absolute latitude of the middle of the map's sides.</param>
internal sealed record SyntheticMapSettings(bool IsSouth, double MetresPerPixel, double LatitudeDegrees);
