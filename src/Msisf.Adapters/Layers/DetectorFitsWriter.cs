using Msisf.Adapters.Interop;
using Msisf.Core.Detector;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Scene;

namespace Msisf.Adapters.Layers;

/// <summary>Writes the digital numbers of a detector as a FITS file of one image (docs/detector.md).</summary>
public static class DetectorFitsWriter
{
    /// <summary>Writes one file. The bytes depend on the arguments alone.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    /// <param name="settings">The detector; goes into the header.</param>
    /// <param name="frame">Goes into the header.</param>
    /// <exception cref="ExternalPartException">CFITSIO is missing or fails.</exception>
    public static void Write(
        Stream stream, DetectorNumbers numbers, DetectorSettings settings, FrameMetadata frame, LayerProvenance provenance)
    {
        using FitsUnit unit = FitsUnit.PrimaryImage(1, 1);
        Put(unit, numbers.Noise, settings, frame, provenance);
        numbers.CopyTo(stream, unit);
    }

    private static void Put(
        FitsUnit unit, NoiseSeed? seed, DetectorSettings settings, FrameMetadata frame, LayerProvenance provenance)
    {
        unit.Put("BUNIT", "adu", "digital numbers");
        unit.Put("EXPTIME", settings.ExposureTime, "[s] exposure time");
        unit.Put("GAIN", settings.Gain, "[electron/adu]");
        unit.Put("RDNOISE", settings.ReadNoise, "[electron] standard deviation");
        unit.Put("SATURATE", settings.MaxNumber, "[adu] highest number");
        unit.Put("ADCBITS", settings.ConverterBits, "bits of the converter");
        unit.Put("BIAS", settings.Bias, "[adu] of a pixel without electrons");
        unit.Put("DARKCUR", settings.Dark.Rate * settings.Dark.TemperatureFactor, "[electron/s] mean dark current");
        unit.Put("CCD-TEMP", settings.Dark.Temperature, "[Celsius] of the detector");
        if (double.IsFinite(settings.FullWell))
        {
            unit.Put("FULLWELL", settings.FullWell, "[electron] full well");
        }

        if (settings.Shutter is { } shutter)
        {
            // DATE-OBS is the middle of the exposure, of a rolling shutter that of the middle row.
            unit.Put("SHUTTER", shutter.IsRolling ? "rolling" : "global", "when the rows are exposed");
            unit.Put("LINETIME", shutter.LineTime, "[s] from a row's exposure to the next");
        }

        unit.Put(
            "SEED", settings.Seed?.ToString(CultureInfo.InvariantCulture) ?? "none",
            seed is null ? "of all random numbers" : "of the fixed pattern");
        if (seed is { } noise)
        {
            unit.Put("NOISSEED", noise.Number.ToString(CultureInfo.InvariantCulture), "of the noise (--noise-seed)");
            unit.Put("NOISSTEP", noise.Step.ToString(CultureInfo.InvariantCulture), "step of the noise");
        }

        unit.Put("ROWORDER", "TOP-DOWN", "first row of the file is the image's top");
        FitsProvenance.Put(unit, frame, provenance);
    }
}
