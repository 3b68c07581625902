namespace Msisf.Core.Detector;

/// <summary>A number that depends on the wavelength: the same everywhere, or straight lines between points. Immutable.</summary>
public sealed class SpectralCurve
{
    private readonly double[] _wavelengths;
    private readonly double[] _values;

    /// <summary>The same value at all wavelengths.</summary>
    /// <param name="value">0 to 1.</param>
    public SpectralCurve(double value)
    {
        _wavelengths = [];
        _values = [Guard.InRange(value, 0.0, 1.0, "A spectral value")];
    }

    /// <summary>Straight lines between points.</summary>
    /// <param name="points">Wavelength in nm, increasing, and value, 0 to 1; at least two.</param>
    /// <exception cref="BadInputException">Too few points, wavelengths that do not increase, or a value out of range.</exception>
    public SpectralCurve(IReadOnlyList<(double Wavelength, double Value)> points)
    {
        if (points.Count < 2)
        {
            throw new BadInputException($"A table of wavelengths has {points.Count} lines; 2 or more are needed.");
        }

        _wavelengths = [.. points.Select(point => Guard.Positive(point.Wavelength, "A wavelength (nm)"))];
        _values = [.. points.Select(point => Guard.InRange(point.Value, 0.0, 1.0, "A spectral value"))];
        for (int i = 1; i < _wavelengths.Length; i++)
        {
            if (_wavelengths[i] <= _wavelengths[i - 1])
            {
                throw new BadInputException(
                    $"The wavelength {_wavelengths[i]:R} nm follows {_wavelengths[i - 1]:R} nm; they must increase.");
            }
        }
    }

    /// <summary>nm: wavelengths of the points; empty if the value is the same everywhere.</summary>
    public IReadOnlyList<double> Wavelengths => _wavelengths;

    /// <summary>The value at a wavelength; 0 outside the points.</summary>
    /// <param name="wavelength">nm.</param>
    public double At(double wavelength)
    {
        if (_wavelengths.Length == 0)
        {
            return _values[0];
        }

        int found = Array.BinarySearch(_wavelengths, wavelength);
        if (found >= 0)
        {
            return _values[found];
        }

        int next = ~found;
        if (next == 0 || next == _wavelengths.Length)
        {
            return 0.0;
        }

        double part = (wavelength - _wavelengths[next - 1]) / (_wavelengths[next] - _wavelengths[next - 1]);
        return _values[next - 1] + (part * (_values[next] - _values[next - 1]));
    }
}
