namespace Msisf.Adapters.Interop;

/// <summary>
/// One header and data unit of a FITS file. CFITSIO makes it in memory, and it is then copied to a stream: so the file is written as
/// atomically as any other, and no more than one unit is in memory. Texts are ASCII. Every result is checked.
/// </summary>
internal sealed unsafe class FitsUnit : IDisposable
{
    /// <summary>bytes: the header of an empty primary unit, and one of some 70 keywords; CFITSIO takes more if it needs it.</summary>
    private const int DefaultHeaders = 4 * Block;

    /// <summary>bytes: FITS files consist of blocks of this length.</summary>
    private const int Block = 2880;

    /// <summary>CFITSIO's name for BITPIX 16 with BZERO 32768.</summary>
    private const int UnsignedShortImage = 20;

    private readonly IFitsStore _store;
    private readonly CFitsioHandle _file;

    private FitsUnit(IFitsStore store)
    {
        CFitsio.RequireLibrary(CFitsioNative.Library);
        _store = store;
        int status = 0;
        lock (CFitsio.Gate)
        {
            _store.Open(out _file, ref status);
            if (status != 0)
            {
                _store.Dispose();
            }

            CFitsio.ThrowIfFailed(status, nameof(CFitsioNative.ffimem));
        }
    }

    /// <summary>Starts a primary unit without data.</summary>
    /// <exception cref="ExternalPartException">CFITSIO is missing or fails.</exception>
    public static FitsUnit Primary()
    {
        FitsUnit unit = InMemory(DefaultHeaders);
        unit.CreateOrDispose(8, []);
        return unit;
    }

    /// <summary>Starts a primary unit with an image of unsigned numbers of 16 bits (BZERO 32768).</summary>
    /// <param name="width">NAXIS1.</param>
    /// <param name="height">NAXIS2.</param>
    /// <exception cref="ExternalPartException">CFITSIO is missing or fails.</exception>
    public static FitsUnit PrimaryImage(int width, int height)
    {
        FitsUnit unit = InMemory(((long)sizeof(ushort) * width * height) + DefaultHeaders);
        unit.CreateOrDispose(UnsignedShortImage, [width, height]);
        return unit;
    }

    /// <summary>Starts an IMAGE extension.</summary>
    /// <param name="path">Path of a file for it while CFITSIO has it; null to have it in memory.</param>
    /// <param name="bitsPerPixel">BITPIX.</param>
    /// <param name="lengths">NAXIS1 (fastest), NAXIS2, ...</param>
    /// <exception cref="ExternalPartException">CFITSIO is missing or fails.</exception>
    public static FitsUnit Image(string? path, int bitsPerPixel, params ReadOnlySpan<long> lengths)
    {
        long bytes = Math.Abs(bitsPerPixel) / 8;
        foreach (long length in lengths)
        {
            bytes *= length;
        }

        FitsUnit unit = path is null ? InMemory(bytes + DefaultHeaders) : new FitsUnit(new FitsDiskFile(path));
        unit.CreateOrDispose(8, []); // an extension needs a primary unit before it, which is not copied
        unit.CreateOrDispose(bitsPerPixel, lengths);
        return unit;
    }

    /// <summary>Adds a keyword; a text of more than 68 characters goes on in CONTINUE cards.</summary>
    public void Put(string key, string value, string comment) =>
        Checked(key, (ref int status) => CFitsioNative.ffpkls(_file, key, value, comment, ref status));

    /// <summary>Adds a keyword with a whole number.</summary>
    public void Put(string key, long value, string comment) =>
        Checked(key, (ref int status) => CFitsioNative.ffpkyj(_file, key, value, comment, ref status));

    /// <summary>Adds a keyword with a number that reads back to the bit.</summary>
    public void Put(string key, double value, string comment)
    {
        int digits = 15;
        while (digits < 17
            && double.Parse(value.ToString($"G{digits}", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture) != value)
        {
            digits++;
        }

        Checked(key, (ref int status) => CFitsioNative.ffpkyd(_file, key, value, -digits, comment, ref status));
    }

    /// <summary>Adds the cards that tell readers of CONTINUE cards.</summary>
    public void DeclareLongTexts() =>
        Checked(nameof(CFitsioNative.ffplsw), (ref int status) => CFitsioNative.ffplsw(_file, ref status));

    /// <summary>Adds a COMMENT card.</summary>
    /// <param name="text">Up to 72 characters; a longer one is cut into several cards.</param>
    public void PutComment(string text) =>
        Checked(nameof(CFitsioNative.ffpcom), (ref int status) => CFitsioNative.ffpcom(_file, text, ref status));

    /// <summary>Writes pixels.</summary>
    /// <typeparam name="T">The image's own type: byte, ushort, int, float or double; in memory order of the machine.</typeparam>
    /// <param name="first">Where they begin in the image, from 0.</param>
    /// <param name="values">Written as they are.</param>
    public void Write<T>(long first, ReadOnlySpan<T> values)
        where T : unmanaged
    {
        fixed (T* pointer = values)
        {
            lock (CFitsio.Gate)
            {
                int status = 0;
                CFitsioNative.ffppr(_file, TypeCode<T>(), first + 1, values.Length, pointer, ref status);
                CFitsio.ThrowIfFailed(status, nameof(CFitsioNative.ffppr));
            }
        }
    }

    /// <summary>The same image compressed without loss, in tiles of whole rows, as a table that readers show as the image.</summary>
    /// <param name="path">Path of a file for it while CFITSIO has it; null to have it in memory.</param>
    /// <param name="lengths">NAXIS1, NAXIS2, ... of the image.</param>
    /// <exception cref="ExternalPartException">CFITSIO fails.</exception>
    public FitsUnit Compressed(string? path, int tileRows, params ReadOnlySpan<long> lengths)
    {
        Span<long> tile = stackalloc long[lengths.Length];
        tile.Fill(1);
        tile[0] = lengths[0];
        tile[1] = Math.Min(tileRows, lengths[1]);
        FitsUnit compressed = path is null
            ? InMemory(Block) // when CFITSIO moves the end of a table, it takes memory behind it for units
            : new FitsUnit(new FitsDiskFile(path));
        compressed.CreateOrDispose(8, []);
        int status = 0;
        lock (CFitsio.Gate)
        {
            CFitsioNative.ffflus(_file, ref status);
            CFitsioNative.fits_set_compression_type(compressed._file, CFitsioNative.ShuffledGzip, ref status);
            CFitsioNative.fits_set_quantize_level(compressed._file, CFitsioNative.NoQuantization, ref status);
            fixed (long* pointer = tile)
            {
                CFitsioNative.fits_set_tile_dim(compressed._file, tile.Length, pointer, ref status);
            }
        }

        // Seconds of a large image: a library that allows it compresses several files at a time.
        bool isLocked = !CFitsio.IsReentrant;
        if (isLocked)
        {
            CFitsio.Gate.Enter();
        }

        CFitsioNative.fits_img_compress(_file, compressed._file, ref status);
        if (isLocked)
        {
            CFitsio.Gate.Exit();
        }

        lock (CFitsio.Gate)
        {
            if (status != 0)
            {
                compressed.Dispose();
            }

            CFitsio.ThrowIfFailed(status, nameof(CFitsioNative.fits_img_compress));
        }

        return compressed;
    }

    /// <summary>Sets the checksums and copies the unit to a stream. Nothing can be added after that.</summary>
    public void CopyTo(Stream destination)
    {
        long start;
        long end;
        lock (CFitsio.Gate)
        {
            int status = 0;
            FitsChecksums.Put(_file, ref status);
            CFitsioNative.ffflus(_file, ref status);
            CFitsioNative.ffghadll(_file, out start, out _, out end, ref status);
            CFitsio.ThrowIfFailed(status, "checksums");
        }

        _store.CopyTo(destination, start, end);
    }

    /// <summary>Copies an image with data that CFITSIO does not have.</summary>
    /// <param name="destination">Receives the unit.</param>
    /// <param name="width">NAXIS1.</param>
    /// <param name="height">NAXIS2.</param>
    /// <param name="data">The pixels as the file holds them.</param>
    public void CopyTo(Stream destination, int width, int height, ReadOnlySpan<byte> data)
    {
        destination.Write(HeaderOf(width, height, FitsSum.Of(data)));
        destination.Write(data);
        destination.Write(new byte[FillOf(data.Length)]);
    }

    /// <summary>
    /// The header of an image with data that CFITSIO does not have. It knows the image as one of a single pixel in each plane, which needs
    /// no memory; the header gets the true lengths and checksums. Nothing can be added after that.
    /// </summary>
    /// <param name="width">NAXIS1.</param>
    /// <param name="height">NAXIS2.</param>
    /// <param name="dataSum">The sum of the pixels as the file holds them (<see cref="FitsSum"/>).</param>
    public byte[] HeaderOf(int width, int height, uint dataSum)
    {
        byte[] header;
        lock (CFitsio.Gate)
        {
            int status = 0;
            FitsChecksums.PutDataSum(_file, dataSum, ref status);
            CFitsioNative.ffghadll(_file, out long start, out long dataStart, out _, ref status);
            CFitsio.ThrowIfFailed(status, "header");
            using MemoryStream copy = new();
            _store.CopyTo(copy, start, dataStart);
            header = copy.ToArray();
        }

        FitsCards.SetNumber(header, "NAXIS1", width);
        FitsCards.SetNumber(header, "NAXIS2", height);
        byte* text = stackalloc byte[CFitsioNative.ChecksumLength];
        CFitsioNative.ffesum(FitsSum.Of(dataSum, FitsSum.Of(header)), complement: 1, text);
        FitsCards.SetText(header, "CHECKSUM", new ReadOnlySpan<byte>(text, CFitsioNative.ChecksumLength - 1));
        return header;
    }

    /// <summary>Zeros behind data that fill whole blocks, bytes.</summary>
    public static int FillOf(long dataLength) => (int)((Block - (dataLength % Block)) % Block);

    public void Dispose()
    {
        _file.Dispose();
        _store.Dispose();
    }

    private static void Checked(string what, Call call)
    {
        lock (CFitsio.Gate)
        {
            int status = 0;
            call(ref status);
            CFitsio.ThrowIfFailed(status, what);
        }
    }

    private static FitsUnit InMemory(long capacity) => new(new FitsMemory(checked((nuint)capacity)));

    private static int TypeCode<T>()
        where T : unmanaged => default(T) switch
        {
            byte => CFitsioNative.TypeByte,
            ushort => CFitsioNative.TypeUnsignedShort,
            int => CFitsioNative.TypeInt,
            float => CFitsioNative.TypeFloat,
            double => CFitsioNative.TypeDouble,
            _ => throw new ArgumentException($"No FITS image has pixels of type {typeof(T)}.", nameof(T)),
        };

    private void CreateOrDispose(int bitsPerPixel, ReadOnlySpan<long> lengths)
    {
        int status = 0;
        lock (CFitsio.Gate)
        {
            fixed (long* pointer = lengths)
            {
                CFitsioNative.ffcrimll(_file, bitsPerPixel, lengths.Length, pointer, ref status);
            }

            if (status != 0)
            {
                Dispose();
            }

            CFitsio.ThrowIfFailed(status, nameof(CFitsioNative.ffcrimll));
        }
    }

    private delegate int Call(ref int status);
}
