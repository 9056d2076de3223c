(()=>{var Wr=class{buffer=null;pos=0;streamPos=0;stream=null;windowSize=0;w=null;buf;constructor(t=null,e=4096){this.w=t,this.stream=t,this.windowSize=e,this.buf=new Uint8Array(e),this.buffer=this.buf,this.pos=0,this.streamPos=0}copyBlock(t,e){if(this.buffer)for(let i=0;i<e;i++){let n=this.pos-t-1;n<0&&(n+=this.windowSize);let r=this.buffer[n];this.putByte(r)}}putByte(t){this.buffer&&(this.buffer[this.pos]=t,this.pos++,this.streamPos++,this.pos>=this.windowSize&&this.flush())}getByte(t){if(!this.buffer)return 0;let e=this.pos+t;return e<0?e+=this.windowSize:e>=this.windowSize&&(e-=this.windowSize),this.buffer[e]}flush(){this.w&&this.buffer&&this.pos>0&&(this.w.writeBytes(this.buffer,0,this.pos),this.pos=0)}isEmpty(){return this.streamPos===0}reset(){this.pos=0,this.streamPos=0,this.buffer&&this.buffer.fill(0)}};var Xr=class{stream=null;code=0;rrange=0;setStream(t){this.stream=t}init(){this.code=0,this.rrange=-1;for(let t=0;t<5;++t)this.code=this.code<<8|this.readFromStream()}decodeBit(t,e){let i,n=t[e];return i=(this.rrange>>>11)*n,(this.code^-2147483648)<(i^-2147483648)?(this.rrange=i,t[e]=n+(2048-n>>>5),this.rrange&-16777216||(this.code=this.code<<8|this.readFromStream(),this.rrange<<=8),0):(this.rrange-=i,this.code-=i,t[e]=n-(n>>>5),this.rrange&-16777216||(this.code=this.code<<8|this.readFromStream(),this.rrange<<=8),1)}decodeDirectBits(t){let e=0;for(let i=t;i!=0;i-=1){this.rrange>>>=1;let n=this.code-this.rrange>>>31;this.code-=this.rrange&n-1,e=e<<1|1-n,this.rrange&-16777216||(this.code=this.code<<8|this.readFromStream(),this.rrange<<=8)}return e}get currentCode(){return this.code}get currentRange(){return this.rrange}readFromStream(){return this.stream?this.stream.readByte():0}};var zs=[0,1996959894,3993919788,2567524794,124634137,1886057615,3915621685,2657392035,249268274,2044508324,3772115230,2547177864,162941995,2125561021,3887607047,2428444049,498536548,1789927666,4089016648,2227061214,450548861,1843258603,4107580753,2211677639,325883990,1684777152,4251122042,2321926636,335633487,1661365465,4195302755,2366115317,997073096,1281953886,3579855332,2724688242,1006888145,1258607687,3524101629,2768942443,901097722,1119000684,3686517206,2898065728,853044451,1172266101,3705015759,2882616665,651767980,1373503546,3369554304,3218104598,565507253,1454621731,3485111705,3099436303,671266974,1594198024,3322730930,2970347812,795835527,1483230225,3244367275,3060149565,1994146192,31158534,2563907772,4023717930,1907459465,112637215,2680153253,3904427059,2013776290,251722036,2517215374,3775830040,2137656763,141376813,2439277719,3865271297,1802195444,476864866,2238001368,4066508878,1812370925,453092731,2181625025,4111451223,1706088902,314042704,2344532202,4240017532,1658658271,366619977,2362670323,4224994405,1303535960,984961486,2747007092,3569037538,1256170817,1037604311,2765210733,3554079995,1131014506,879679996,2909243462,3663771856,1141124467,855842277,2852801631,3708648649,1342533948,654459306,3188396048,3373015174,1466479909,544179635,3110523913,3462522015,1591671054,702138776,2966460450,3352799412,1504918807,783551873,3082640443,3233442989,3988292384,2596254646,62317068,1957810842,3939845945,2647816111,81470997,1943803523,3814918930,2489596804,225274430,2053790376,3826175755,2466906013,167816743,2097651377,4027552580,2265490386,503444072,1762050814,4150417245,2154129355,426522225,1852507879,4275313526,2312317920,282753626,1742555852,4189708143,2394877945,397917763,1622183637,3604390888,2714866558,953729732,1340076626,3518719985,2797360999,1068828381,1219638859,3624741850,2936675148,906185462,1090812512,3747672003,2825379669,829329135,1181335161,3412177804,3160834842,628085408,1382605366,3423369109,3138078467,570562233,1426400815,3317316542,2998733608,733239954,1555261956,3268935591,3050360625,752459403,1541320221,2607071920,3965973030,1969922972,40735498,2617837225,3943577151,1913087877,83908371,2512341634,3803740692,2075208622,213261112,2463272603,3855990285,2094854071,198958881,2262029012,4057260610,1759359992,534414190,2176718541,4139329115,1873836001,414664567,2282248934,4279200368,1711684554,285281116,2405801727,4167216745,1634467795,376229701,2685067896,3608007406,1308918612,956543938,2808555105,3495958263,1231636301,1047427035,2932959818,3654703836,1088359270,936918e3,2847714899,3736837829,1202900863,817233897,3183342108,3401237130,1404277552,615818150,3134207493,3453421203,1423857449,601450431,3009837614,3294710456,1567103746,711928724,3020668471,3272380065,1510334235,755167117],le=pp(),Hi=mp();function Yt(s,t=0){let e=[];if(e[s-1]=void 0,t!==0)for(let i=0;i<s;i++)e[i]=t;return e}function mi(s,t){return le[((s-t^-t)&2047)>>>2]}function Vt(s){for(let t=s.length-1;t>=0;--t)s[t]=1024}function jn(s){return s-=2,s<4?s:3}var jh=[0,0,0,0,1,2,3,4,5,6,4,5];function Li(s){return s>=0&&s<jh.length?jh[s]:s<4?0:s<10?s-3:s-6}function Ie(s){return{numBitLevels:s,models:Yt(1<<s)}}function pp(){let s=[];for(let t=8;t>=0;--t){let e=1<<9-t-1,i=1<<9-t;for(let n=e;n<i;++n)s[n]=(t<<6)+(i-n<<6>>>9-t-1)}return s}function mp(){let s=[0,1],t=2;for(let e=2;e<22;++e){let i=1<<(e>>1)-1;for(let n=0;n<i;++n,++t)s[t]=e}return s}var Yr=class{rangeDecoder;outWindow;state=0;rep0=0;rep1=0;rep2=0;rep3=0;prevByte=0;nowPos64=0n;outSize=0n;posStateMask=0;dictSizeCheck=0;matchDecoders=[];rep0LongDecoders=[];repDecoders=[];repG0Decoders=[];repG1Decoders=[];repG2Decoders=[];posDecoders=[];literalDecoder;posSlotDecoders=[];lenDecoder;repLenDecoder;posAlignDecoder;get literalCoder(){return this.literalDecoder}constructor(){this.rangeDecoder=new Xr,this.outWindow=new Wr(null,4096),this.matchDecoders=Yt(192),this.rep0LongDecoders=Yt(192),this.repDecoders=Yt(12),this.repG0Decoders=Yt(12),this.repG1Decoders=Yt(12),this.repG2Decoders=Yt(12),this.posDecoders=Yt(114),this.literalDecoder={coders:[],numPrevBits:0,numPosBits:0,posMask:0,init:()=>this.initLiteralDecoder()};for(let t=0;t<4;t++)this.posSlotDecoders[t]=Ie(6);this.lenDecoder=this.createLenDecoder(),this.repLenDecoder=this.createLenDecoder(),this.posAlignDecoder=Ie(4)}initDecompression(t,e){let i=[];for(let r=0;r<5;++r){let o=t.readByte();if(o===-1)throw new Error("truncated input");i[r]=o<<24>>24}if(!this.setDecoderProperties(i))throw new Error("corrupted input");let n;{let r=0n;for(let o=0;o<8;o++){let a=t.readByte();if(a===-1)throw new Error("truncated input");r+=BigInt(a&255)<<BigInt(o*8)}r===0xffffffffffffffffn||r>BigInt(4294967295)?n=-1n:n=r}this.rangeDecoder.setStream(t),this.flush(),this.outWindow.stream=null,this.outWindow.stream=e,this.init(),this.state=0,this.rep0=0,this.rep1=0,this.rep2=0,this.rep3=0,this.outSize=n,this.nowPos64=0n,this.prevByte=0}decompress(t,e){for(this.initDecompression(t,e);;){let i=this.codeOneChunk();if(i===-1)throw new Error("corrupted input");let n=this.outSize>=0n&&this.nowPos64>=this.outSize;if(i||n){this.flush(),this.cleanup();return}}}createLenDecoder(){return{choice:Yt(2),lowCoder:[],midCoder:[],highCoder:Ie(8),numPosStates:0}}setDecoderProperties(t){if(t.length<5)return!1;let e=t[0]%9,i=Math.floor(t[0]/9),n=i%5,r=Math.floor(i/5);if(r>4)return!1;this.literalDecoder.numPrevBits=e,this.literalDecoder.numPosBits=n,this.literalDecoder.posMask=(1<<n)-1,this.posStateMask=(1<<r)-1;let o=0;for(let c=0;c<4;c++){let l=t[1+c]&255;o+=l<<c*8}this.dictSizeCheck=Math.max(o,1),o>0&&(this.outWindow.windowSize=Math.max(o,4096),this.outWindow.buffer=new Uint8Array(this.outWindow.windowSize));let a=1<<this.literalDecoder.numPrevBits+this.literalDecoder.numPosBits;this.literalDecoder.coders=[];for(let c=0;c<a;c++)this.literalDecoder.coders[c]={decoders:Yt(768)};this.lenDecoder.numPosStates=1<<r,this.repLenDecoder.numPosStates=1<<r,this.lenDecoder.lowCoder=[],this.lenDecoder.midCoder=[],this.repLenDecoder.lowCoder=[],this.repLenDecoder.midCoder=[];for(let c=0;c<1<<r;c++)this.lenDecoder.lowCoder[c]=Ie(3),this.lenDecoder.midCoder[c]=Ie(3),this.repLenDecoder.lowCoder[c]=Ie(3),this.repLenDecoder.midCoder[c]=Ie(3);return!0}copyBlock(t){let e=this.outWindow,i=this.rep0,n=e.pos-i-1;for(n<0&&(n+=e.windowSize);t!=0;t-=1)n>=e.windowSize&&(n=0),e.buffer[e.pos]=e.buffer[n],e.pos+=1,n+=1,e.pos>=e.windowSize&&this.flush()}putByte(t){this.outWindow.buffer[this.outWindow.pos]=t,this.outWindow.pos+=1,this.outWindow.pos>=this.outWindow.windowSize&&this.flush()}getByte(t){let e=this.outWindow,i=e.pos-t-1;return i<0&&(i+=e.windowSize),e.buffer[i]}getDecoder(t,e){let i=t&this.literalDecoder.posMask,n=(e&255)>>>8-this.literalDecoder.numPrevBits,r=(i<<this.literalDecoder.numPrevBits)+n;return this.literalDecoder.coders[r]}initLiteralDecoder(){let t=1<<this.literalDecoder.numPrevBits+this.literalDecoder.numPosBits;for(let e=0;e<t;++e)for(let i=0;i<this.literalDecoder.coders[e].decoders.length;i++)this.literalDecoder.coders[e].decoders[i]=1024}init(){this.outWindow.streamPos=0,this.outWindow.pos=0,Vt(this.matchDecoders),Vt(this.rep0LongDecoders),Vt(this.repDecoders),Vt(this.repG0Decoders),Vt(this.repG1Decoders),Vt(this.repG2Decoders),Vt(this.posDecoders),this.initLiteralDecoder();for(let t=0;t<4;++t)Vt(this.posSlotDecoders[t].models);this.initLenDecoder(this.lenDecoder),this.initLenDecoder(this.repLenDecoder),Vt(this.posAlignDecoder.models),this.initRangeDecoder()}initLenDecoder(t){Vt(t.choice);for(let e=0;e<t.numPosStates;++e)Vt(t.lowCoder[e].models),Vt(t.midCoder[e].models);Vt(t.highCoder.models)}outWindowReleaseStream(){this.flush(),this.outWindow.stream=null}decodeBit(t,e){return this.rangeDecoder.decodeBit(t,e)}decodeDirectBits(t){return this.rangeDecoder.decodeDirectBits(t)}initRangeDecoder(){this.rangeDecoder.init()}rangeBitTreeDecoder(t){let e,i=1;for(e=t.numBitLevels;e!=0;e-=1)i=(i<<1)+this.decodeBit(t.models,i);return i-(1<<t.numBitLevels)}reverseDecode(t,e,i){let n=0;for(let r=0,o=1,a;r<i;++r)a=this.decodeBit(t,e+o),o<<=1,o+=a,n|=a<<r;return n}reverseDecodeAlignDecoder(){let t=0;for(let e=1,i=0,n;i<this.posAlignDecoder.numBitLevels;++i)n=this.decodeBit(this.posAlignDecoder.models,e),e<<=1,e+=n,t|=n<<i;return t}decodeNormalWithRangeDecoder(t){let e=1;do e=e<<1|this.decodeBit(t.decoders,e);while(e<256);return e<<24>>24}decodeWithMatchByteWithRangeDecoder(t,e){let i,n,r=1;do if(n=e>>7&1,e<<=1,i=this.decodeBit(t.decoders,(1+n<<8)+r),r=r<<1|i,n!=i){for(;r<256;)r=r<<1|this.decodeBit(t.decoders,r);break}while(r<256);return r<<24>>24}decodeLenWithRangeDecoder(t,e){if(!this.decodeBit(t.choice,0))return this.rangeBitTreeDecoder(t.lowCoder[e]);let i=8;return this.decodeBit(t.choice,1)?i+=8+this.rangeBitTreeDecoder(t.highCoder):i+=this.rangeBitTreeDecoder(t.midCoder[e]),i}codeOneChunk(){let t,e,i,n,r,o=Number(this.nowPos64&0xffffffffn)&this.posStateMask;if(!this.decodeBit(this.matchDecoders,(this.state<<4)+o))t=this.getDecoder(Number(this.nowPos64&0xffffffffn),this.prevByte),this.state<7?this.prevByte=this.decodeNormalWithRangeDecoder(t):this.prevByte=this.decodeWithMatchByteWithRangeDecoder(t,this.getByte(this.rep0)),this.putByte(this.prevByte),this.state=Li(this.state),this.nowPos64+=1n;else{if(this.decodeBit(this.repDecoders,this.state))i=0,this.decodeBit(this.repG0Decoders,this.state)?(this.decodeBit(this.repG1Decoders,this.state)?(this.decodeBit(this.repG2Decoders,this.state)?(e=this.rep3,this.rep3=this.rep2):e=this.rep2,this.rep2=this.rep1):e=this.rep1,this.rep1=this.rep0,this.rep0=e):this.decodeBit(this.rep0LongDecoders,(this.state<<4)+o)||(this.state=this.state<7?9:11,i=1),i||(i=this.decodeLenWithRangeDecoder(this.repLenDecoder,o)+2,this.state=this.state<7?8:11);else if(this.rep3=this.rep2,this.rep2=this.rep1,this.rep1=this.rep0,i=2+this.decodeLenWithRangeDecoder(this.lenDecoder,o),this.state=this.state<7?7:10,r=this.rangeBitTreeDecoder(this.posSlotDecoders[jn(i)]),r>=4){if(n=(r>>1)-1,this.rep0=(2|r&1)<<n,r<14)this.rep0+=this.reverseDecode(this.posDecoders,this.rep0-r-1,n);else if(this.rep0+=this.decodeDirectBits(n-4)<<4,this.rep0+=this.reverseDecodeAlignDecoder(),this.rep0<0)return this.rep0==-1?1:-1}else this.rep0=r;if(BigInt(this.rep0)>=this.nowPos64||this.rep0>=this.dictSizeCheck)return-1;this.copyBlock(i),this.nowPos64+=BigInt(i),this.prevByte=this.getByte(0)}return 0}writeToOutput(t,e,i,n){t.writeBytes(e,i,n)}flush(){let t=this.outWindow.pos-this.outWindow.streamPos;t&&(this.outWindow.stream&&this.outWindow.buffer&&this.outWindow.stream.writeBytes(this.outWindow.buffer,this.outWindow.streamPos,t),this.outWindow.pos>=this.outWindow.windowSize&&(this.outWindow.pos=0),this.outWindow.streamPos=this.outWindow.pos)}cleanup(){this.outWindow.stream=null,this.rangeDecoder.stream=null}};var $r=class{choice=Yt(2);lowCoder=[];midCoder=[];highCoder=Ie(8);tableSize=0;prices=[];counters=[];constructor(){for(let t=0;t<16;++t)this.lowCoder[t]=Ie(3),this.midCoder[t]=Ie(3)}init(t){Vt(this.choice);for(let e=0;e<t;++e)Vt(this.lowCoder[e].models),Vt(this.midCoder[e].models);Vt(this.highCoder.models)}encode(t,e,i){t<8?(i.encodeBit(this.choice,0,0),i.encodeBitTree(this.lowCoder[e],t)):(t-=8,i.encodeBit(this.choice,0,1),t<8?(i.encodeBit(this.choice,1,0),i.encodeBitTree(this.midCoder[e],t)):(i.encodeBit(this.choice,1,1),i.encodeBitTree(this.highCoder,t-8)))}encodeWithUpdate(t,e,i){this.encode(t,e,i),this.counters&&(this.counters[e]-=1)==0&&(this.counters[e]=this.tableSize)}getPrice(t,e){return this.prices[e*272+t]}initPriceTable(){this.prices=[],this.counters=[]}setTableSize(t){this.tableSize=t}setTableSizeAndInitCounters(t,e){if(this.tableSize=t,this.counters)for(let i=0;i<e;++i)this.counters[i]=t}getTableSize(){return this.tableSize}updateTables(t){(!this.prices||!this.counters)&&this.initPriceTable();for(let e=0;e<t;++e)this.setPrices(e,this.tableSize,this.prices,0),this.counters&&(this.counters[e]=this.tableSize)}getBitTreePrice(t,e){let i,n,r=1,o=0;for(n=t.numBitLevels;n!=0;)n-=1,i=e>>>n&1,o+=this.getBitPrice(t.models[r],i),r=(r<<1)+i;return o}getBitPrice(t,e){return mi(t,e)}setPrices(t,e,i,n){let r=this.getBitPrice(this.choice[0],0),o=this.getBitPrice(this.choice[0],1),a=o+this.getBitPrice(this.choice[1],0),c=o+this.getBitPrice(this.choice[1],1),l=0,h=n+t*272;for(l=0;l<8;++l){if(l>=e)return;i[h+l]=r+this.getBitTreePrice(this.lowCoder[t],l)}for(;l<16;++l){if(l>=e)return;i[h+l]=a+this.getBitTreePrice(this.midCoder[t],l-8)}for(;l<e;++l)i[h+l]=c+this.getBitTreePrice(this.highCoder,l-8-8)}};var Gc=class{coders;constructor(){this.coders=Yt(768,1024)}decodeNormal(t){let e=1;for(;e<256;){let i=t.decodeBit(this.coders,e);e=e<<1|i}return e&255}decodeWithMatchByte(t,e){let i=e,n=1;for(;n<256;){let r=i>>7&1;i<<=1;let o=t.decodeBit(this.coders,(1+r<<8)+n);if(n=n<<1|o,r!==o){for(;n<256;){let a=t.decodeBit(this.coders,n);n=n<<1|a}break}}return n&255}encode(t,e){let i=1;for(let n=7;n>=0;n--){let r=e>>n&1;t.encodeBit(this.coders,i,r),i=i<<1|r}}encodeMatched(t,e,i){let n=e,r=1,o=!0;for(let a=7;a>=0;a--){let c=i>>a&1,l=r;if(o){let h=n>>a&1;l+=1+h<<8,o=h===c}t.encodeBit(this.coders,l,c),r=r<<1|c}}getPrice(t,e,i){let n=e,r=0,o=1,a=7;if(t)for(;a>=0;){let c=n>>a&1,l=i>>a&1;if(r+=mi(this.coders[1+c<<8+o],l),o=o<<1|l,c!==l){a--;break}a--}for(;a>=0;){let c=i>>a&1;r+=mi(this.coders[o],c),o=o<<1|c,a--}return r}reset(){this.coders.fill(1024)}get decoders(){return this.coders}},Zr=class{_coders;_numPrevBits;_posMask;constructor(t,e){let i=1<<e+t;this._coders=[],this._numPrevBits=e,this._posMask=(1<<t)-1;for(let n=0;n<i;n++)this._coders[n]=new Gc}getSubCoder(t,e){return this._coders[((t&this._posMask)<<this._numPrevBits)+(e>>8-this._numPrevBits)]}reset(){this._coders.forEach(t=>t.reset())}get numPrevBits(){return this._numPrevBits}get numPosBits(){return Math.log2(this._posMask+1)}get posMask(){return this._posMask}get coders(){return this._coders}};var Jr=class{_posLimit=0;_bufferBase=new Uint8Array(0);_pos=0;_streamPos=0;_streamEndWasReached=0;_bufferOffset=0;_blockSize=0;_keepSizeBefore=0;_keepSizeAfter=0;_pointerToLastSafePosition=0;_stream=null;HASH_ARRAY=!0;kNumHashDirectBytes=0;kMinMatchCheck=4;kFixHashSize=66560;_hashMask=0;_hashSizeSum=0;_hash=new Int32Array(0);_cyclicBufferSize=0;_cyclicBufferPos=0;_son=new Int32Array(0);_matchMaxLen=0;_cutValue=255;getIndexByte(t){return this._bufferBase[this._bufferOffset+this._pos+t]}getMatchLen(t,e,i){this._streamEndWasReached&&this._pos+t+i>this._streamPos&&(i=this._streamPos-(this._pos+t)),++e;let n,r=this._bufferOffset+this._pos+t;for(n=0;n<i&&this._bufferBase[r+n]==this._bufferBase[r+n-e];++n);return n}getNumAvailableBytes(){return this._streamPos-this._pos}moveBlock(){let t=this._bufferOffset+this._pos-this._keepSizeBefore;t>0&&--t;let e=this._bufferOffset+this._streamPos-t;this._bufferBase.copyWithin(0,t,t+e),this._bufferOffset-=t}movePosInWindow(){this._pos+=1,this._pos>this._posLimit&&(this._bufferOffset+this._pos>this._pointerToLastSafePosition&&this.moveBlock(),this.readBlock())}readBlock(){if(!this._streamEndWasReached)for(;;){let t=-this._bufferOffset+this._blockSize-this._streamPos;if(!t)return;let e=this.readFromStream(this._bufferOffset+this._streamPos,t);if(e==-1){this._posLimit=this._streamPos,this._bufferOffset+this._posLimit>this._pointerToLastSafePosition&&(this._posLimit=this._pointerToLastSafePosition-this._bufferOffset),this._streamEndWasReached=1;return}this._streamPos+=e,this._streamPos>=this._pos+this._keepSizeAfter&&(this._posLimit=this._streamPos-this._keepSizeAfter)}}reduceOffsets(t){this._bufferOffset+=t,this._posLimit-=t,this._pos-=t,this._streamPos-=t}readFromStream(t,e){let i=this._stream,n=this._bufferBase;return i.readBytes(n,t,e)}createBuffers(t,e,i){this._keepSizeBefore=t,this._keepSizeAfter=e;let n=t+e+i;this._blockSize!=n&&(this._bufferBase=new Uint8Array(n),this._blockSize=n),this._pointerToLastSafePosition=this._blockSize-e}create(t,e,i,n){if(t<1073741823){this._cutValue=16+(e>>1);let r=~~((t+i+e+n)/2)+256;this.createBuffers(t+i,e+n,r),this._matchMaxLen=e;let o=t+1;this._cyclicBufferSize!==o&&(this._cyclicBufferSize=o,this._son=new Int32Array(o*2));let a=65536;if(this.HASH_ARRAY){a=t-1,a|=a>>1,a|=a>>2,a|=a>>4,a|=a>>8,a>>=1,a|=65535,a>16777216&&(a>>=1),this._hashMask=a,a+=1;let c=a+this.kFixHashSize;c!==this._hashSizeSum&&(this._hashSizeSum=c,this._hash=new Int32Array(c))}else a!==this._hashSizeSum&&(this._hashSizeSum=a,this._hash=new Int32Array(a))}}getMatches(t){let e,i,n,r,o,a,c,l,h,u,d,f,g,x,p,m,S,C,b,A,E;if(this._pos+this._matchMaxLen<=this._streamPos)x=this._matchMaxLen;else if(x=this._streamPos-this._pos,x<this.kMinMatchCheck)return this.movePos(),0;for(S=0,p=this._pos>this._cyclicBufferSize?this._pos-this._cyclicBufferSize:0,i=this._bufferOffset+this._pos,m=1,l=0,h=0,this.HASH_ARRAY?(E=zs[this._bufferBase[i]]^this._bufferBase[i+1],l=E&1023,E^=this._bufferBase[i+2]<<8,h=E&65535,u=(E^zs[this._bufferBase[i+3]]<<5)&this._hashMask):u=this._bufferBase[i]^this._bufferBase[i+1]<<8,n=this._hash[this.kFixHashSize+u]||0,this.HASH_ARRAY&&(r=this._hash[l]||0,o=this._hash[1024+h]||0,this._hash[l]=this._pos,this._hash[1024+h]=this._pos,r>p&&this._bufferBase[this._bufferOffset+r]==this._bufferBase[i]&&(t[S++]=m=2,t[S++]=this._pos-r-1),o>p&&this._bufferBase[this._bufferOffset+o]==this._bufferBase[i]&&(o==r&&(S-=2),t[S++]=m=3,t[S++]=this._pos-o-1,r=o),S!=0&&r==n&&(S-=2,m=1)),this._hash[this.kFixHashSize+u]=this._pos,b=(this._cyclicBufferPos<<1)+1,A=this._cyclicBufferPos<<1,f=g=this.kNumHashDirectBytes,this.kNumHashDirectBytes!=0&&n>p&&this._bufferBase[this._bufferOffset+n+this.kNumHashDirectBytes]!=this._bufferBase[i+this.kNumHashDirectBytes]&&(t[S++]=m=this.kNumHashDirectBytes,t[S++]=this._pos-n-1),e=this._cutValue;;){if(n<=p||e==0){e-=1,this._son[b]=this._son[A]=0;break}if(c=this._pos-n,a=(c<=this._cyclicBufferPos?this._cyclicBufferPos-c:this._cyclicBufferPos-c+this._cyclicBufferSize)<<1,C=this._bufferOffset+n,d=f<g?f:g,this._bufferBase[C+d]==this._bufferBase[i+d]){for(;(d+=1)!=x&&this._bufferBase[C+d]==this._bufferBase[i+d];);if(m<d&&(t[S++]=m=d,t[S++]=c-1,d==x)){this._son[A]=this._son[a],this._son[b]=this._son[a+1];break}}this._bufferBase[C+d]<this._bufferBase[i+d]?(this._son[A]=n,A=a+1,n=this._son[A],g=d):(this._son[b]=n,b=a,n=this._son[b],f=d)}return this.movePos(),S}skip(t){let e,i,n,r,o,a,c,l,h,u,d,f,g,x,p,m,S;do{if(this._pos+this._matchMaxLen<=this._streamPos)f=this._matchMaxLen;else if(f=this._streamPos-this._pos,f<this.kMinMatchCheck){this.movePos();continue}for(g=this._pos>this._cyclicBufferSize?this._pos-this._cyclicBufferSize:0,i=this._bufferOffset+this._pos,this.HASH_ARRAY?(S=zs[this._bufferBase[i]]^this._bufferBase[i+1],a=S&1023,this._hash[a]=this._pos,S^=this._bufferBase[i+2]<<8,c=S&65535,this._hash[1024+c]=this._pos,l=(S^zs[this._bufferBase[i+3]]<<5)&this._hashMask):l=this._bufferBase[i]^this._bufferBase[i+1]<<8,n=this._hash[this.kFixHashSize+l],this._hash[this.kFixHashSize+l]=this._pos,p=(this._cyclicBufferPos<<1)+1,m=this._cyclicBufferPos<<1,u=d=this.kNumHashDirectBytes,e=this._cutValue;;){if(n<=g||e==0){e-=1,this._son[p]=this._son[m]=0;break}if(o=this._pos-n,r=(o<=this._cyclicBufferPos?this._cyclicBufferPos-o:this._cyclicBufferPos-o+this._cyclicBufferSize)<<1,x=this._bufferOffset+n,h=u<d?u:d,this._bufferBase[x+h]==this._bufferBase[i+h]){for(;(h+=1)!=f&&this._bufferBase[x+h]==this._bufferBase[i+h];);if(h==f){this._son[m]=this._son[r],this._son[p]=this._son[r+1];break}}this._bufferBase[x+h]<this._bufferBase[i+h]?(this._son[m]=n,m=r+1,n=this._son[m],d=h):(this._son[p]=n,p=r,n=this._son[p],u=h)}this.movePos()}while((t-=1)!=0)}movePos(){if((this._cyclicBufferPos+=1)>=this._cyclicBufferSize&&(this._cyclicBufferPos=0),this.movePosInWindow(),this._pos==1073741823){let t=this._pos-this._cyclicBufferSize;this.normalizeLinks(this._son,this._cyclicBufferSize*2,t),this.normalizeLinks(this._hash,this._hashSizeSum,t),this.reduceOffsets(t)}}init(){this._bufferOffset=0,this._pos=0,this._streamPos=0,this._streamEndWasReached=0,this.readBlock(),this._cyclicBufferPos=0,this.reduceOffsets(-1)}normalizeLinks(t,e,i){for(let n=0;n<e;++n){let r=t[n];r<=i?r=0:r-=i,t[n]=r}}setType(t){this.HASH_ARRAY=t>2,this.HASH_ARRAY?(this.kNumHashDirectBytes=0,this.kMinMatchCheck=4,this.kFixHashSize=66560):(this.kNumHashDirectBytes=2,this.kMinMatchCheck=3,this.kFixHashSize=0)}};var Kr=new Map;function Sp(s){return s<<6}function Vc(s,t){let e=s.numBitLevels<<16|t;if(Kr.has(e))return Kr.get(e);let i=0,n=1;for(let r=s.numBitLevels;r>0;r--){let o=t>>>r-1&1;i+=mi(s.models[n],o),n=(n<<1)+o}return Kr.size<1e4&&Kr.set(e,i),i}var Hc=class{state=0;previousByte=0;position=0n;repDistances=[0,0,0,0];longestMatchLength=0;longestMatchWasFound=!1;additionalOffset=0;isMatch=Yt(192);isRep=Yt(12);isRepG0=Yt(12);isRepG1=Yt(12);isRepG2=Yt(12);isRep0Long=Yt(192);initModels(){Vt(this.isMatch),Vt(this.isRep),Vt(this.isRepG0),Vt(this.isRepG1),Vt(this.isRepG2),Vt(this.isRep0Long)}updateRepDistances(t,e){if(e===0)this.repDistances[3]=this.repDistances[2],this.repDistances[2]=this.repDistances[1],this.repDistances[1]=this.repDistances[0],this.repDistances[0]=t;else{let i=this.repDistances[e];for(let n=e;n>0;n--)this.repDistances[n]=this.repDistances[n-1];this.repDistances[0]=i}}},Wc=class{posSlotEncoder=[];posEncoders=Yt(114);posAlignEncoder;constructor(){for(let t=0;t<4;t++)this.posSlotEncoder[t]=Ie(6);this.posAlignEncoder=Ie(4)}init(){for(let t of this.posSlotEncoder)Vt(t.models);Vt(this.posEncoders),Vt(this.posAlignEncoder.models)}encodePosition(t,e,i){let n=this.getPosSlot(t);if(i.encodeBitTree(this.posSlotEncoder[e],n),n>=4){let r=(n>>1)-1,o=(2|n&1)<<r,a=t-o;n<14?this.encodeReverseBits(a,r,i):(i.encodeDirectBits(a>>4,r-4),i.encodeBitTree(this.posAlignEncoder,a&15))}}getPositionPrice(t,e){let i=this.getPosSlot(t),n=Vc(this.posSlotEncoder[e],i);if(i>=4){let r=(i>>1)-1,o=(2|i&1)<<r,a=t-o;i<14?n+=this.getReverseBitsPrice(a,r):(n+=Sp(r-4),n+=Vc(this.posAlignEncoder,a&15))}return n}getPosSlot(t){return t<4?t:t<1<<20?Hi[t>>6]+12:Hi[t>>26]+52}encodeReverseBits(t,e,i){let n=1;for(let r=0;r<e;r++){let o=t&1;i.encodeBit(this.posEncoders,n,o),n=n<<1|o,t>>>=1}}getReverseBitsPrice(t,e){let i=0,n=1;for(let r=0;r<e;r++){let o=t&1;i+=mi(this.posEncoders[n],o),n=n<<1|o,t>>>=1}return i}},jr=class{encoderState=new Hc;positionEncoder=new Wc;_state=0;_previousByte=0;_distTableSize=0;_longestMatchWasFound=0;_optimumEndIndex=0;_optimumCurrentIndex=0;_additionalOffset=0;_dictionarySize=0;_matchFinder=null;_dictionarySizePrev=0;_numFastBytes=0;_numLiteralContextBits=0;_numLiteralPosStateBits=0;_posStateBits=0;_posStateMask=0;_needReleaseMFStream=0;_inStream=null;_finished=0;nowPos64=0n;_repDistances=Yt(4);_optimum=[];_rangeEncoder={stream:null,rrange:0,cache:0,low:0n,cacheSize:0,position:0n,encodeBit:()=>{},encodeBitTree:()=>{},encodeDirectBits:()=>{}};_isMatch=Yt(192);_isRep=Yt(12);_isRepG0=Yt(12);_isRepG1=Yt(12);_isRepG2=Yt(12);_isRep0Long=Yt(192);_posSlotEncoder=[];_posEncoders=Yt(114);_posAlignEncoder=null;_lenEncoder=null;_repMatchLenEncoder=null;_literalEncoder=null;_matchDistances=[];_posSlotPrices=[];_distancesPrices=[];_alignPrices=Yt(16);_matchPriceCount=0;_alignPriceCount=0;reps=Yt(4);repLens=Yt(4);processedInSize=[0n];processedOutSize=[0n];finished=[0];properties=new Uint8Array(5);tempPrices=Yt(128);_longestMatchLength=0;_matchFinderType=1;_numDistancePairs=0;_numFastBytesPrev=-1;backRes=0;constructor(){}baseInit(){this._state=0,this._previousByte=0;for(let t=0;t<4;++t)this._repDistances[t]=0}getOptimum(){return this._optimum}getBackRes(){return this.backRes}setBackRes(t){this.backRes=t}init(){this.baseInit(),this.encoderState.initModels(),this.positionEncoder.init(),this._optimum=[];for(let t=0;t<4096;t++)this._optimum[t]={};this.initEncoderState(),Vt(this._isMatch),Vt(this._isRep0Long),Vt(this._isRep),Vt(this._isRepG0),Vt(this._isRepG1),Vt(this._isRepG2),Vt(this._posEncoders),this.initLiteralEncoder();for(let t=0;t<4;++t)Vt(this._posSlotEncoder[t].models);this._lenEncoder&&this._lenEncoder.init(1<<this._posStateBits),this._repMatchLenEncoder&&this._repMatchLenEncoder.init(1<<this._posStateBits),this._posAlignEncoder&&Vt(this._posAlignEncoder.models),this._longestMatchWasFound=0,this._optimumEndIndex=0,this._optimumCurrentIndex=0,this._additionalOffset=0}initEncoderState(){this._rangeEncoder.low=0n,this._rangeEncoder.rrange=4294967295,this._rangeEncoder.cacheSize=1,this._rangeEncoder.cache=0,this._rangeEncoder.position=0n}initLiteralEncoder(){let t=1<<this._literalEncoder.numPrevBits+this._literalEncoder.numPosBits;for(let e=0;e<t;++e)Vt(this._literalEncoder.coders[e].decoders)}createOptimumStructures(){for(let t=0;t<4096;++t)this._optimum[t]={};for(let t=0;t<4;++t)this._posSlotEncoder[t]=Ie(6)}createLenPriceTableEncoder(){let t=new $r;return t.initPriceTable(),t}createLiteralEncoderEncoder2(){return{decoders:Yt(768)}}createLiteralEncoder(){this._literalEncoder!=null&&this._literalEncoder.numPrevBits==this._numLiteralContextBits&&this._literalEncoder.numPosBits==this._numLiteralPosStateBits||(this._literalEncoder=new Zr(this._numLiteralPosStateBits,this._numLiteralContextBits))}initialize(){this._lenEncoder=this.createLenPriceTableEncoder(),this._repMatchLenEncoder=this.createLenPriceTableEncoder(),this._posAlignEncoder=Ie(4),this._optimum=[],this.createOptimumStructures(),this.createLiteralEncoder(),this.init()}configure(t){this.setDictionarySize(1<<t.searchDepth),this._numFastBytes=t.filterStrength,this._matchFinderType=t.modeIndex,this._numLiteralContextBits=3,this._numLiteralPosStateBits=0,this._posStateBits=2,this._posStateMask=3}setDictionarySize(t){this._dictionarySize=t;let e=0;for(;t>1<<e;++e);this._distTableSize=e*2}encodeBit(t,e,i){let n=this._rangeEncoder,r,o=t[e];r=(n.rrange>>>11)*o,i?(n.low+=BigInt(r>>>0),n.rrange-=r,t[e]=o-(o>>>5)):(n.rrange=r,t[e]=o+(2048-o>>>5)),n.rrange&-16777216||(n.rrange<<=8,this.shiftLow())}encodeBitTree(t,e){let i,n,r=1;for(n=t.numBitLevels;n!=0;)n-=1,i=e>>>n&1,this.encodeBit(t.models,r,i),r=r<<1|i}encodeLiteral(t,e){let i,n=1;for(let r=7;r>=0;--r)i=e>>r&1,this.encodeBit(t.decoders,n,i),n=n<<1|i}encodeMatched(t,e,i){let n,r,o,a=!0,c=1;for(let l=7;l>=0;--l)n=i>>l&1,o=c,a&&(r=e>>l&1,o+=1+r<<8,a=r===n),this.encodeBit(t.decoders,o,n),c=c<<1|n}encodeLength(t,e,i){t.encode(e,i,this)}encodeDirectBits(t,e){let i=this._rangeEncoder;for(let n=e-1;n>=0;n-=1)i.rrange>>>=1,(t>>>n&1)==1&&(i.low+=BigInt(i.rrange>>>0)),i.rrange&-16777216||(i.rrange<<=8,this.shiftLow())}reverseEncode(t){let e=this._posAlignEncoder;if(!e)return;let i,n=1;for(let r=0;r<e.numBitLevels;++r)i=t&1,this.encodeBit(e.models,n,i),n=n<<1|i,t>>=1}reverseEncodeRange(t,e,i){let n,r=1;for(let o=0;o<e;++o)n=i&1,this.encodeBit(this._posEncoders,t+r,n),r=r<<1|n,i>>=1}writeEndMarker(t){this.encodeBit(this._isMatch,(this._state<<4)+t,1),this.encodeBit(this._isRep,this._state,0),this._state=this._state<7?7:10,this.encodeLength(this._lenEncoder,0,t);let e=63,i=jn(2);this.encodeBitTree(this._posSlotEncoder[i],e),this.encodeDirectBits(67108863,26),this.reverseEncode(15)}encodeLengthWithPriceUpdate(t,e,i){t.encodeWithUpdate(e,i,this)}shiftLow(){let t=this._rangeEncoder,e=Number(t.low>>32n&0xffffffffn),i=Number(t.low&0xffffffffn);if(e!=0||i<4278190080){t.position+=BigInt(t.cacheSize);let n=t.cache;do this.writeToStream(t.stream,n+e),n=255;while((t.cacheSize-=1)!=0);t.cache=i>>>24&255}t.cacheSize+=1,t.low=BigInt(i&16777215)<<8n}writeToStream(t,e){t&&t.writeByte(e<<24>>24)}initRangeEncoder(){this._rangeEncoder.position=0n,this._rangeEncoder.low=0n,this._rangeEncoder.rrange=-1,this._rangeEncoder.cacheSize=1,this._rangeEncoder.cache=0}fillAlignPrices(){for(let t=0;t<16;++t)this._alignPrices[t]=this.reverseGetPrice(this._posAlignEncoder,t);this._alignPriceCount=0}fillDistancesPrices(){let t,e,i,n,r,o;for(let a=4;a<128;++a)n=this.getPosSlot(a),i=(n>>1)-1,t=(2|n&1)<<i,this.tempPrices[a]=this.reverseGetPriceArray(this._posEncoders,t-n-1,i,a-t);for(let a=0;a<4;++a){for(e=this._posSlotEncoder[a],r=a<<6,n=0;n<this._distTableSize;n+=1)this._posSlotPrices[r+n]=this.getEncoderBitTreePrice(e,n);for(n=14;n<this._distTableSize;n+=1)this._posSlotPrices[r+n]+=(n>>1)-1-4<<6;o=a*128;for(let c=0;c<4;++c)this._distancesPrices[o+c]=this._posSlotPrices[r+c];for(let c=4;c<128;++c)this._distancesPrices[o+c]=this._posSlotPrices[r+this.getPosSlot(c)]+this.tempPrices[c]}this._matchPriceCount=0}getPosSlot(t){return t<2048?Hi[t]:t<2097152?Hi[t>>10]+20:Hi[t>>20]+40}reverseGetPrice(t,e){let i,n=1,r=0;for(let o=t.numBitLevels;o!=0;o-=1)i=e&1,e>>>=1,r+=this.getPrice(t.models[n],i),n=n<<1|i;return r}reverseGetPriceArray(t,e,i,n){let r,o=1,a=0;for(let c=i;c!=0;c-=1)r=n&1,n>>>=1,a+=le[((t[e+o]-r^-r)&2047)>>>2],o=o<<1|r;return a}getPrice(t,e){return mi(t,e)}getEncoderBitTreePrice(t,e){return Vc(t,e)}createEncoderStructures(){this._optimum=[];for(let t=0;t<4096;t++)this._optimum[t]={};for(let t=0;t<4096;++t)this._optimum[t]={};this._posSlotEncoder=new Array(4);for(let t=0;t<4;++t)this._posSlotEncoder[t]=Ie(6)}getSubCoderUtility(t,e){let n=(t&this._literalEncoder.posMask)<<this._literalEncoder.numPrevBits,r=8-this._literalEncoder.numPrevBits,o=(e&255)>>>r,a=n+o;return this._literalEncoder.coders[a]}makeAsChar(t){t.backPrev=-1,t.prev1IsChar=0}makeAsShortRep(t){t.backPrev=0,t.prev1IsChar=0}releaseMFStream(){this._matchFinder&&this._needReleaseMFStream&&(this._matchFinder._stream=null,this._needReleaseMFStream=0)}releaseStreams(){this.releaseMFStream(),this._rangeEncoder.stream=null}getProcessedSizeAdd(){return BigInt(this._rangeEncoder.cacheSize)+this._rangeEncoder.position+4n}getSubCoder(t,e){return{decoders:this._literalEncoder.getSubCoder(t,e).decoders}}getLiteralPrice(t,e,i,n){let r,o=1,a=7,c,l=0;if(e){for(;a>=0;--a)if(c=i>>a&1,r=n>>a&1,l+=mi(t.decoders[(1+c<<8)+o],r),o=o<<1|r,c!=r){--a;break}}for(;a>=0;--a)r=n>>a&1,l+=mi(t.decoders[o],r),o=o<<1|r;return l}getPosLenPrice(t,e,i){let n,r=jn(e);if(t<128)n=this._distancesPrices[r*128+t];else{let o=(r<<6)+this.getPosSlot2(t);n=this._posSlotPrices[o]+this._alignPrices[t&15]}return n+this._lenEncoder.getPrice(e-2,i)}getPureRepPrice(t,e,i){let n;return t?(n=le[2048-this._isRepG0[e]>>>2],t==1?n+=le[this._isRepG1[e]>>>2]:(n+=le[2048-this._isRepG1[e]>>>2],n+=mi(this._isRepG2[e],t-2))):(n=le[this._isRepG0[e]>>>2],n+=le[2048-this._isRep0Long[(e<<4)+i]>>>2]),n}getRepLen1Price(t){let e=le[this._isRepG0[this._state]>>>2],i=le[this._isRep0Long[(this._state<<4)+t]>>>2];return e+i}getPosSlot2(t){return t<131072?Hi[t>>6]+12:t<134217728?Hi[t>>16]+32:Hi[t>>26]+52}movePosHelper(t){t>0&&(this._matchFinder.skip(t),this._additionalOffset+=t)}readMatchDistances(){let t=0;return this._numDistancePairs=this._matchFinder.getMatches(this._matchDistances),this._numDistancePairs>0&&(t=this._matchDistances[this._numDistancePairs-2],t==this._numFastBytes&&(t+=this._matchFinder.getMatchLen(t-1,this._matchDistances[this._numDistancePairs-1],273-t))),this._additionalOffset+=1,t}flushEncoding(t){this.releaseMFStream(),this.writeEndMarker(t&this._posStateMask);for(let e=0;e<5;++e)this.shiftLow()}backward(t){let e,i,n,r;this._optimumEndIndex=t,n=this._optimum[t].posPrev,i=this._optimum[t].backPrev;do this._optimum[t].prev1IsChar&&(this.makeAsChar(this._optimum[n]),this._optimum[n].posPrev=n-1,this._optimum[t].prev2&&(this._optimum[n-1].prev1IsChar=0,this._optimum[n-1].posPrev=this._optimum[t].posPrev2,this._optimum[n-1].backPrev=this._optimum[t].backPrev2)),r=n,e=i,i=this._optimum[r].backPrev,n=this._optimum[r].posPrev,this._optimum[r].backPrev=e,this._optimum[r].posPrev=t,t=r;while(t>0);return this.backRes=this._optimum[0].backPrev,this._optimumCurrentIndex=this._optimum[0].posPrev,this._optimumCurrentIndex}getOptimumLength(t){let e,i,n,r,o,a,c,l,h,u,d,f,g,x,p,m,S,C,b,A,E,_,M,F,P,L,B,z,T,V,W,G,Q,X,J,tt,yt,Tt,Y,dt,et,xt,ft,Nt,ge,Pt,jt,ne,Ut;if(this._optimumEndIndex!=this._optimumCurrentIndex)return Ut=this._optimum[this._optimumCurrentIndex].posPrev-this._optimumCurrentIndex,this.backRes=this._optimum[this._optimumCurrentIndex].backPrev,this._optimumCurrentIndex=this._optimum[this._optimumCurrentIndex].posPrev,Ut;if(this._optimumCurrentIndex=this._optimumEndIndex=0,this._longestMatchWasFound?(d=this._longestMatchLength,this._longestMatchWasFound=0):d=this.readMatchDistances(),P=this._numDistancePairs,M=this._matchFinder.getNumAvailableBytes()+1,M<2)return this.backRes=-1,1;M>273&&(M=273),Tt=0;for(let Qt=0;Qt<4;++Qt)this.reps[Qt]=this._repDistances[Qt],this.repLens[Qt]=this._matchFinder.getMatchLen(-1,this.reps[Qt],273),this.repLens[Qt]>this.repLens[Tt]&&(Tt=Qt);if(this.repLens[Tt]>=this._numFastBytes)return this.backRes=Tt,Ut=this.repLens[Tt],this.movePosHelper(Ut-1),Ut;if(d>=this._numFastBytes)return this.backRes=this._matchDistances[P-1]+4,this.movePosHelper(d-1),d;if(c=this._matchFinder.getIndexByte(-1),p=this._matchFinder.getIndexByte(-this._repDistances[0]-1-1),d<2&&c!=p&&this.repLens[Tt]<2)return this.backRes=-1,1;if(this._optimum[0].state=this._state,G=t&this._posStateMask,this._optimum[1].price=le[this._isMatch[(this._state<<4)+G]>>>2]+this.getLiteralPrice(this.getSubCoder(t,this._previousByte),this._state>=7,p,c),this.makeAsChar(this._optimum[1]),m=le[2048-this._isMatch[(this._state<<4)+G]>>>2],yt=m+le[2048-this._isRep[this._state]>>>2],p==c&&(Y=yt+this.getRepLen1Price(G),Y<this._optimum[1].price&&(this._optimum[1].price=Y,this.makeAsShortRep(this._optimum[1]))),u=d>=this.repLens[Tt]?d:this.repLens[Tt],u<2)return this.backRes=this._optimum[1].backPrev,1;this._optimum[1].posPrev=0,this._optimum[0].backs0=this.reps[0],this._optimum[0].backs1=this.reps[1],this._optimum[0].backs2=this.reps[2],this._optimum[0].backs3=this.reps[3],h=u;do this._optimum[h].price=268435455,h-=1;while(h>=2);for(let Qt=0;Qt<4;++Qt)if(tt=this.repLens[Qt],!(tt<2)){X=yt+this.getPureRepPrice(Qt,this._state,G);do r=X+this._repMatchLenEncoder.getPrice(tt-2,G),T=this._optimum[tt],r<T.price&&(T.price=r,T.posPrev=0,T.backPrev=Qt,T.prev1IsChar=0);while((tt-=1)>=2)}if(_=m+le[this._isRep[this._state]>>>2],h=this.repLens[0]>=2?this.repLens[0]+1:2,h<=d){for(L=0;h>this._matchDistances[L];)L+=2;for(;l=this._matchDistances[L+1],r=_+this.getPosLenPrice(l,h,G),T=this._optimum[h],r<T.price&&(T.price=r,T.posPrev=0,T.backPrev=l+4,T.prev1IsChar=0),!(h==this._matchDistances[L]&&(L+=2,L==P));h+=1);}for(e=0;;){if(++e,e==u)return this.backward(e);if(S=this.readMatchDistances(),P=this._numDistancePairs,S>=this._numFastBytes)return this._longestMatchLength=S,this._longestMatchWasFound=1,this.backward(e);if(t+=1,W=this._optimum[e].posPrev,this._optimum[e].prev1IsChar?(W-=1,this._optimum[e].prev2?(et=this._optimum[this._optimum[e].posPrev2].state,this._optimum[e].backPrev2<4?et=et<7?8:11:et=et<7?7:10):et=this._optimum[W].state,et=Li(et)):et=this._optimum[W].state,W==e-1?this._optimum[e].backPrev?et=Li(et):et=et<7?9:11:(this._optimum[e].prev1IsChar&&this._optimum[e].prev2?(W=this._optimum[e].posPrev2,V=this._optimum[e].backPrev2,et=et<7?8:11):(V=this._optimum[e].backPrev,V<4?et=et<7?8:11:et=et<7?7:10),z=this._optimum[W],V<4?V?V==1?(this.reps[0]=z.backs1,this.reps[1]=z.backs0,this.reps[2]=z.backs2,this.reps[3]=z.backs3):V==2?(this.reps[0]=z.backs2,this.reps[1]=z.backs0,this.reps[2]=z.backs1,this.reps[3]=z.backs3):(this.reps[0]=z.backs3,this.reps[1]=z.backs0,this.reps[2]=z.backs1,this.reps[3]=z.backs2):(this.reps[0]=z.backs0,this.reps[1]=z.backs1,this.reps[2]=z.backs2,this.reps[3]=z.backs3):(this.reps[0]=V-4,this.reps[1]=z.backs0,this.reps[2]=z.backs1,this.reps[3]=z.backs2)),this._optimum[e].state=et,this._optimum[e].backs0=this.reps[0],this._optimum[e].backs1=this.reps[1],this._optimum[e].backs2=this.reps[2],this._optimum[e].backs3=this.reps[3],a=this._optimum[e].price,c=this._matchFinder.getIndexByte(-1),p=this._matchFinder.getIndexByte(-this.reps[0]-1-1),G=t&this._posStateMask,i=a+le[this._isMatch[(et<<4)+G]>>>2]+this.getLiteralPrice(this.getSubCoder(t,this._matchFinder.getIndexByte(-2)),et>=7,p,c),A=this._optimum[e+1],C=0,i<A.price&&(A.price=i,A.posPrev=e,A.backPrev=-1,A.prev1IsChar=0,C=1),m=a+le[2048-this._isMatch[(et<<4)+G]>>>2],yt=m+le[2048-this._isRep[et]>>>2],p==c&&!(A.posPrev<e&&!A.backPrev)&&(Y=yt+(le[this._isRepG0[et]>>>2]+le[this._isRep0Long[(et<<4)+G]>>>2]),Y<=A.price&&(A.price=Y,A.posPrev=e,A.backPrev=0,A.prev1IsChar=0,C=1)),F=this._matchFinder.getNumAvailableBytes()+1,F=4095-e<F?4095-e:F,M=F,!(M<2)){if(M>this._numFastBytes&&(M=this._numFastBytes),!C&&p!=c&&(ft=Math.min(F-1,this._numFastBytes),g=this._matchFinder.getMatchLen(0,this.reps[0],ft),g>=2)){for(xt=Li(et),Q=t+1&this._posStateMask,E=i+le[2048-this._isMatch[(xt<<4)+Q]>>>2]+le[2048-this._isRep[xt]>>>2],B=e+1+g;u<B;)this._optimum[u+=1].price=268435455;r=E+(Nt=this._repMatchLenEncoder.getPrice(g-2,Q),Nt+this.getPureRepPrice(0,xt,Q)),T=this._optimum[B],r<T.price&&(T.price=r,T.posPrev=e+1,T.backPrev=0,T.prev1IsChar=1,T.prev2=0)}for(dt=2,J=0;J<4;++J)if(f=this._matchFinder.getMatchLen(-1,this.reps[J],M),!(f<2)){x=f;do{for(;u<e+f;)this._optimum[u+=1].price=268435455;r=yt+(ge=this._repMatchLenEncoder.getPrice(f-2,G),ge+this.getPureRepPrice(J,et,G)),T=this._optimum[e+f],r<T.price&&(T.price=r,T.posPrev=e,T.backPrev=J,T.prev1IsChar=0)}while((f-=1)>=2);if(f=x,J||(dt=f+1),f<F&&(ft=Math.min(F-1-f,this._numFastBytes),g=this._matchFinder.getMatchLen(f,this.reps[J],ft),g>=2)){for(xt=et<7?8:11,Q=t+f&this._posStateMask,n=yt+(Pt=this._repMatchLenEncoder.getPrice(f-2,G),Pt+this.getPureRepPrice(J,et,G))+le[this._isMatch[(xt<<4)+Q]>>>2]+this.getLiteralPrice(this.getSubCoder(t+f,this._matchFinder.getIndexByte(f-1-1)),!0,this._matchFinder.getIndexByte(f-1-(this.reps[J]+1)),this._matchFinder.getIndexByte(f-1)),xt=Li(xt),Q=t+f+1&this._posStateMask,b=n+le[2048-this._isMatch[(xt<<4)+Q]>>>2],E=b+le[2048-this._isRep[xt]>>>2],B=f+1+g;u<e+B;)this._optimum[u+=1].price=268435455;r=E+(jt=this._repMatchLenEncoder.getPrice(g-2,Q),jt+this.getPureRepPrice(0,xt,Q)),T=this._optimum[e+B],r<T.price&&(T.price=r,T.posPrev=e+f+1,T.backPrev=0,T.prev1IsChar=1,T.prev2=1,T.posPrev2=e,T.backPrev2=J)}}if(S>M){for(S=M,P=0;S>this._matchDistances[P];P+=2);this._matchDistances[P]=S,P+=2}if(S>=dt){for(_=m+le[this._isRep[et]>>>2];u<e+S;)this._optimum[u+=1].price=268435455;for(L=0;dt>this._matchDistances[L];)L+=2;for(f=dt;;f+=1)if(o=this._matchDistances[L+1],r=_+this.getPosLenPrice(o,f,G),T=this._optimum[e+f],r<T.price&&(T.price=r,T.posPrev=e,T.backPrev=o+4,T.prev1IsChar=0),f==this._matchDistances[L]){if(f<F&&(ft=Math.min(F-1-f,this._numFastBytes),g=this._matchFinder.getMatchLen(f,o,ft),g>=2)){for(xt=et<7?7:10,Q=t+f&this._posStateMask,n=r+le[this._isMatch[(xt<<4)+Q]>>>2]+this.getLiteralPrice(this.getSubCoder(t+f,this._matchFinder.getIndexByte(f-1-1)),!0,this._matchFinder.getIndexByte(f-(o+1)-1),this._matchFinder.getIndexByte(f-1)),xt=Li(xt),Q=t+f+1&this._posStateMask,b=n+le[2048-this._isMatch[(xt<<4)+Q]>>>2],E=b+le[2048-this._isRep[xt]>>>2],B=f+1+g;u<e+B;)this._optimum[u+=1].price=268435455;r=E+(ne=this._repMatchLenEncoder.getPrice(g-2,Q),ne+this.getPureRepPrice(0,xt,Q)),T=this._optimum[e+B],r<T.price&&(T.price=r,T.posPrev=e+f+1,T.backPrev=0,T.prev1IsChar=1,T.prev2=1,T.posPrev2=e,T.backPrev2=o+4)}if(L+=2,L==P)break}}}}return 1}codeOneBlock(){let t,e,i,n,r,o,a,c,l,h,u,d,f,g;if(this.processedInSize[0]=0n,this.processedOutSize[0]=0n,this.finished[0]=1,f=this.nowPos64,this._inStream&&(this._matchFinder._stream=this._inStream,this._matchFinder.init(),this._needReleaseMFStream=1,this._inStream=null),!this._finished){if(this._finished=1,this.nowPos64===0n){if(!this._matchFinder.getNumAvailableBytes()){this.flushEncoding(Number(this.nowPos64&0xffffffffn));return}this.readMatchDistances(),d=Number(this.nowPos64&0xffffffffn)&this._posStateMask,this.encodeBit(this._isMatch,(this._state<<4)+d,0),this._state=Li(this._state),i=this._matchFinder.getIndexByte(-this._additionalOffset),this.encodeLiteral(this.getSubCoder(Number(this.nowPos64&0xffffffffn),this._previousByte),i),this._previousByte=i,this._additionalOffset-=1,this.nowPos64+=1n}if(!this._matchFinder.getNumAvailableBytes()){this.flushEncoding(Number(this.nowPos64&0xffffffffn));return}for(;;){if(o=this.getOptimumLength(Number(this.nowPos64&0xffffffffn)),l=this.backRes,d=Number(this.nowPos64&0xffffffffn)&this._posStateMask,e=(this._state<<4)+d,o==1&&l==-1)this.encodeBit(this._isMatch,e,0),i=this._matchFinder.getIndexByte(-this._additionalOffset),g=this.getSubCoder(Number(this.nowPos64&0xffffffffn),this._previousByte),this._state<7?this.encodeLiteral(g,i):(c=this._matchFinder.getIndexByte(-this._repDistances[0]-1-this._additionalOffset),this.encodeMatched(g,c,i)),this._previousByte=i,this._state=Li(this._state);else{if(this.encodeBit(this._isMatch,e,1),l<4){if(this.encodeBit(this._isRep,this._state,1),l?(this.encodeBit(this._isRepG0,this._state,1),l==1?this.encodeBit(this._isRepG1,this._state,0):(this.encodeBit(this._isRepG1,this._state,1),this.encodeBit(this._isRepG2,this._state,l-2))):(this.encodeBit(this._isRepG0,this._state,0),o==1?this.encodeBit(this._isRep0Long,e,0):this.encodeBit(this._isRep0Long,e,1)),o==1?this._state=this._state<7?9:11:(this.encodeLength(this._repMatchLenEncoder,o-2,d),this._state=this._state<7?8:11),n=this._repDistances[l],l!=0){for(let x=l;x>=1;--x)this._repDistances[x]=this._repDistances[x-1];this._repDistances[0]=n}}else{this.encodeBit(this._isRep,this._state,0),this._state=this._state<7?7:10,this.encodeLength(this._lenEncoder,o-2,d),l-=4,u=this.getPosSlot(l),a=jn(o),this.encodeBitTree(this._posSlotEncoder[a],u),u>=4&&(r=(u>>1)-1,t=(2|u&1)<<r,h=l-t,u<14?this.reverseEncodeRange(t-u-1,r,h):(this.encodeDirectBits(h>>4,r-4),this.reverseEncode(h&15),this._alignPriceCount+=1)),n=l;for(let x=3;x>=1;--x)this._repDistances[x]=this._repDistances[x-1];this._repDistances[0]=n,this._matchPriceCount+=1}this._previousByte=this._matchFinder.getIndexByte(o-1-this._additionalOffset)}if(this._additionalOffset-=o,this.nowPos64+=BigInt(o),!this._additionalOffset){if(this._matchPriceCount>=128&&this.fillDistancesPrices(),this._alignPriceCount>=16&&this.fillAlignPrices(),this.processedInSize[0]=this.nowPos64,this.processedOutSize[0]=this.getProcessedSizeAdd(),!this._matchFinder.getNumAvailableBytes()){this.flushEncoding(Number(this.nowPos64&0xffffffffn));return}if(this.nowPos64-f>=0x1000n){this._finished=0,this.finished[0]=0;return}}}}}createMatchFinder(){if(!this._matchFinder){let t=new Jr,e=4;this._matchFinderType||(e=2),t.setType(e),this._matchFinder=t}this.createLiteralEncoder(),!(this._dictionarySize==this._dictionarySizePrev&&this._numFastBytesPrev==this._numFastBytes)&&(this._matchFinder.create(this._dictionarySize,this._numFastBytes,4096,274),this._dictionarySizePrev=this._dictionarySize,this._numFastBytesPrev=this._numFastBytes)}writeHeaderProperties(t){this.properties[0]=(this._posStateBits*5+this._numLiteralPosStateBits)*9+this._numLiteralContextBits&255;for(let e=0;e<4;e++)this.properties[1+e]=this._dictionarySize>>8*e&255;for(let e=0;e<5;e++)t.writeByte(this.properties[e])}initCompression(t,e,i,n){if(i<-1n)throw new Error("invalid length "+i);this.initialize(),this.configure(n),this.writeHeaderProperties(e);for(let r=0;r<64;r+=8)e.writeByte(Number(i>>BigInt(r)&0xffn)<<24>>24);this._needReleaseMFStream=0,this._inStream=t,this._finished=0,this.createMatchFinder(),this._rangeEncoder.stream=e,this.init(),this.fillDistancesPrices(),this.fillAlignPrices(),this._lenEncoder.setTableSize(this._numFastBytes+1-2),this._lenEncoder.updateTables(1<<this._posStateBits),this._repMatchLenEncoder.setTableSize(this._numFastBytes+1-2),this._repMatchLenEncoder.updateTables(1<<this._posStateBits),this.nowPos64=0n}compress(t,e,i){this.initCompression(t,e,BigInt(t.count),i);do if(this.codeOneBlock(),this.finished[0]){this.releaseStreams();break}while(!0)}};var Gs=class{buf;pos=0;count;constructor(t){this.buf=t,this.count=t.length}readByte(){return this.pos>=this.count?-1:this.buf[this.pos++]&255}readBytes(t,e,i){return this.pos>=this.count?-1:(i=Math.min(i,this.count-this.pos),t.set(this.buf.subarray(this.pos,this.pos+i),e),this.pos+=i,i)}get remaining(){return this.count-this.pos}},Vs=class{buf;count=0;constructor(t=32){this.buf=new Uint8Array(t)}grow(t){let e=Math.max(this.buf.length*2,t),i=new Uint8Array(e);i.set(this.buf.subarray(0,this.count)),this.buf=i}writeByte(t){this.count>=this.buf.length&&this.grow(this.count+1),this.buf[this.count++]=t}writeBytes(t,e,i){let n=this.count+i;n>this.buf.length&&this.grow(n),this.buf.set(t.subarray(e,e+i),this.count),this.count+=i}write(t){this.writeBytes(t,0,t.length)}toArray(){return this.buf.slice(0,this.count)}};var Mp={1:{searchDepth:16,filterStrength:64,modeIndex:0},2:{searchDepth:20,filterStrength:64,modeIndex:0},3:{searchDepth:19,filterStrength:64,modeIndex:1},4:{searchDepth:20,filterStrength:64,modeIndex:1},5:{searchDepth:21,filterStrength:128,modeIndex:1},6:{searchDepth:22,filterStrength:128,modeIndex:1},7:{searchDepth:23,filterStrength:128,modeIndex:1},8:{searchDepth:24,filterStrength:255,modeIndex:1},9:{searchDepth:25,filterStrength:255,modeIndex:1}},Qr=class{#t=new jr;#e=new Yr;compress(t,e=5){let i=t instanceof ArrayBuffer?new Uint8Array(t):t,n=new Vs(Math.max(32,Math.ceil(i.length*1.2))),r=new Gs(i);this.#t.compress(r,n,Mp[e]);let o=n.toArray();return new Int8Array(o.buffer,o.byteOffset,o.byteLength)}compressString(t,e=5){return this.compress(new Uint8Array(this.#i(t)),e)}decompress(t){let e=t instanceof ArrayBuffer?new Uint8Array(t):t,i=new Vs(Math.max(32,e.length*2)),n=new Gs(e);return this.#e.decompress(n,i),i.toArray()}decompressString(t){let e=this.decompress(t),i=this.#n(e);return typeof i=="string"?i:String.fromCharCode(...i)}#i(t){let e=t.length,i=[];for(let o=0;o<e;++o)i[o]=t.charCodeAt(o);let n=[],r=0;for(let o=0;o<e;++o){let a=i[o];a>=1&&a<=127?n[r++]=a<<24>>24:!a||a>=128&&a<=2047?(n[r++]=(192|a>>6&31)<<24>>24,n[r++]=(128|a&63)<<24>>24):(n[r++]=(224|a>>12&15)<<24>>24,n[r++]=(128|a>>6&63)<<24>>24,n[r++]=(128|a&63)<<24>>24)}return n}#n(t){let e=0,i,n,r,o=t.length,a=[],c=[];for(let l=0;l<o;++l,++e){if(i=t[l]&255,i&128)if((i&224)==192){if(l+1>=o)return String.fromCharCode(...t);if(n=t[++l]&255,(n&192)!=128)return String.fromCharCode(...t);c[e]=(i&31)<<6|n&63}else if((i&240)==224){if(l+2>=o||(n=t[++l]&255,(n&192)!=128)||(r=t[++l]&255,(r&192)!=128))return t;c[e]=(i&15)<<12|(n&63)<<6|r&63}else return t;else{if(!i)return t;c[e]=i}e==16383&&(a.push(String.fromCharCode.apply(String,c)),e=-1)}return e>0&&(c.length=e,a.push(String.fromCharCode.apply(String,c))),a.join("")}};/**
 * @license
 * Copyright Filip Seman
 * SPDX-License-Identifier: MIT
 */function eu(s){let t=s instanceof ArrayBuffer?new Uint8Array(s):s,e=new Qr().decompress(t);return new Uint8Array(e)}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var wn={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},En={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Ou=0,Ml=1,Uu=2;var Hn=1,ku=2,Ts=3,An=0,Ke=1,He=2,Wn=0,Cs=1,bl=2,wl=3,El=4,zu=5;var Xn=100,Gu=101,Vu=102,Hu=103,Wu=104,Xu=200,qu=201,Yu=202,$u=203,Al=204,Tl=205,Zu=206,Ju=207,Ku=208,ju=209,Qu=210,td=211,ed=212,id=213,nd=214,Io=0,Do=1,Lo=2,gs=3,No=4,Fo=5,Bo=6,Oo=7,ca=0,sd=1,rd=2,Ui=0,Cl=1,Rl=2,Pl=3,Il=4,Dl=5,Ll=6,Nl=7;var Fl=300,qn=301,Rs=302,la=303,ha=304,Uo=1e3,Fi=1001,ko=1002,Le=1003,od=1004;var wr=1005;var Ze=1006,ua=1007;var en=1008;var ei=1009,Bl=1010,Ol=1011,Ps=1012,da=1013,Ri=1014,yi=1015,Pi=1016,fa=1017,pa=1018,Yn=1020,Ul=35902,kl=35899,zl=1021,Gl=1022,Ii=1023,Ki=1026,nn=1027,ma=1028,ga=1029,Tn=1030,_a=1031;var xa=1033,Er=33776,Ar=33777,Tr=33778,Cr=33779,ya=35840,va=35841,Sa=35842,Ma=35843,ba=36196,wa=37492,Ea=37496,Aa=37488,Ta=37489,Rr=37490,Ca=37491,Ra=37808,Pa=37809,Ia=37810,Da=37811,La=37812,Na=37813,Fa=37814,Ba=37815,Oa=37816,Ua=37817,ka=37818,za=37819,Ga=37820,Va=37821,Ha=36492,Wa=36494,Xa=36495,qa=36283,Ya=36284,Pr=36285,$a=36286;var js=2300,zo=2301,Ro=2302,fl=2303,pl=2400,ml=2401,gl=2402;var ad=3200;var Za=0,cd=1,sn="",oi="srgb",Un="srgb-linear",Qs="linear",se="srgb";var Po=7680;var ld=519,hd=512,ud=513,dd=514,Vl=515,fd=516,pd=517,Hl=518,Wl=519,md=35044,vi=35048;var Xl="300 es",_i=2e3,_s=2001;function bp(s){for(let t=s.length-1;t>=0;--t)if(s[t]>=65535)return!0;return!1}function wp(s){return ArrayBuffer.isView(s)&&!(s instanceof DataView)}function tr(s){return document.createElementNS("http://www.w3.org/1999/xhtml",s)}function gd(){let s=tr("canvas");return s.style.display="block",s}var iu={},xs=null;function ql(...s){let t="THREE."+s.shift();xs?xs("log",t,...s):console.log(t,...s)}function _d(s){let t=s[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=s[1];e&&e.isStackTrace?s[0]+=" "+e.getLocation():s[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return s}function It(...s){s=_d(s);let t="THREE."+s.shift();if(xs)xs("warn",t,...s);else{let e=s[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...s)}}function Lt(...s){s=_d(s);let t="THREE."+s.shift();if(xs)xs("error",t,...s);else{let e=s[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...s)}}function Js(...s){let t=s.join(" ");t in iu||(iu[t]=!0,It(...s))}function xd(s,t,e){return new Promise(function(i,n){function r(){switch(s.clientWaitSync(t,s.SYNC_FLUSH_COMMANDS_BIT,0)){case s.WAIT_FAILED:n();break;case s.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var yd={[Io]:Io,[Lo]:Bo,[No]:No,[gs]:Fo,[Do]:Do,[Bo]:Lo,[Oo]:Oo,[Fo]:gs},Ai=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let n=i[t];if(n!==void 0){let r=n.indexOf(e);r!==-1&&n.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let n=i.slice(0);for(let r=0,o=n.length;r<o;r++)n[r].call(this,t);t.target=null}}},Ge=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],nu=1234567,ps=Math.PI/180,ys=180/Math.PI;function Is(){let s=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Ge[s&255]+Ge[s>>8&255]+Ge[s>>16&255]+Ge[s>>24&255]+"-"+Ge[t&255]+Ge[t>>8&255]+"-"+Ge[t>>16&15|64]+Ge[t>>24&255]+"-"+Ge[e&63|128]+Ge[e>>8&255]+"-"+Ge[e>>16&255]+Ge[e>>24&255]+Ge[i&255]+Ge[i>>8&255]+Ge[i>>16&255]+Ge[i>>24&255]).toLowerCase()}function Wt(s,t,e){return Math.max(t,Math.min(e,s))}function Yl(s,t){return(s%t+t)%t}function Ep(s,t,e,i,n){return i+(s-t)*(n-i)/(e-t)}function Ap(s,t,e){return s!==t?(e-s)/(t-s):0}function Ks(s,t,e){return(1-e)*s+e*t}function Tp(s,t,e,i){return Ks(s,t,1-Math.exp(-e*i))}function Cp(s,t=1){return t-Math.abs(Yl(s,t*2)-t)}function Rp(s,t,e){return s<=t?0:s>=e?1:(s=(s-t)/(e-t),s*s*(3-2*s))}function Pp(s,t,e){return s<=t?0:s>=e?1:(s=(s-t)/(e-t),s*s*s*(s*(s*6-15)+10))}function Ip(s,t){return s+Math.floor(Math.random()*(t-s+1))}function Dp(s,t){return s+Math.random()*(t-s)}function Lp(s){return s*(.5-Math.random())}function Np(s){s!==void 0&&(nu=s);let t=nu+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Fp(s){return s*ps}function Bp(s){return s*ys}function Op(s){return s>0&&Number.isInteger(s)&&2**Math.round(Math.log2(s))===s}function Up(s){return Math.pow(2,Math.ceil(Math.log(s)/Math.LN2))}function $l(s){return Math.pow(2,Math.floor(Math.log(s)/Math.LN2))}function kp(s,t,e,i,n){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),g=o((i-t)/2);switch(n){case"XYX":s.set(a*h,c*u,c*d,a*l);break;case"YZY":s.set(c*d,a*h,c*u,a*l);break;case"ZXZ":s.set(c*u,c*d,a*h,a*l);break;case"XZX":s.set(a*h,c*g,c*f,a*l);break;case"YXY":s.set(c*f,a*h,c*g,a*l);break;case"ZYZ":s.set(c*g,c*f,a*h,a*l);break;default:It("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+n)}}function Zl(s){switch(s.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function vd(s,t){if(t.constructor===Float32Array)return s;let e=Zl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(s/e,-1)}function Sd(s,t){if(t.constructor===Float32Array)return s;let e=Zl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(s*e)}var $n={DEG2RAD:ps,RAD2DEG:ys,generateUUID:Is,clamp:Wt,euclideanModulo:Yl,mapLinear:Ep,inverseLerp:Ap,lerp:Ks,damp:Tp,pingpong:Cp,smoothstep:Rp,smootherstep:Pp,randInt:Ip,randFloat:Dp,randFloatSpread:Lp,seededRandom:Np,degToRad:Fp,radToDeg:Bp,isPowerOfTwo:Op,ceilPowerOfTwo:Up,floorPowerOfTwo:$l,setQuaternionFromProperEuler:kp,normalize:Sd,denormalize:vd},Rt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,n=t.elements;return this.x=n[0]*e+n[3]*i+n[6],this.y=n[1]*e+n[4]*i+n[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Wt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),n=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*n+t.x,this.y=r*n+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ne=class{constructor(t=0,e=0,i=0,n=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=n}static slerpFlat(t,e,i,n,r,o,a){let c=i[n+0],l=i[n+1],h=i[n+2],u=i[n+3],d=r[o+0],f=r[o+1],g=r[o+2],x=r[o+3];if(u!==x||c!==d||l!==f||h!==g){let p=c*d+l*f+h*g+u*x;p<0&&(d=-d,f=-f,g=-g,x=-x,p=-p);let m=1-a;if(p<.9995){let S=Math.acos(p),C=Math.sin(S);m=Math.sin(m*S)/C,a=Math.sin(a*S)/C,c=c*m+d*a,l=l*m+f*a,h=h*m+g*a,u=u*m+x*a}else{c=c*m+d*a,l=l*m+f*a,h=h*m+g*a,u=u*m+x*a;let S=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=S,l*=S,h*=S,u*=S}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,n,r,o){let a=i[n],c=i[n+1],l=i[n+2],h=i[n+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+h*u+c*f-l*d,t[e+1]=c*g+h*d+l*u-a*f,t[e+2]=l*g+h*f+a*d-c*u,t[e+3]=h*g-a*u-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,n){return this._x=t,this._y=e,this._z=i,this._w=n,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,n=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(n/2),u=a(r/2),d=c(i/2),f=c(n/2),g=c(r/2);switch(o){case"XYZ":this._x=d*h*u+l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u+d*f*g;break;case"YZX":this._x=d*h*u+l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u-d*f*g;break;case"XZY":this._x=d*h*u-l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u+d*f*g;break;default:It("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,n=Math.sin(i);return this._x=t.x*n,this._y=t.y*n,this._z=t.z*n,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],n=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],u=e[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-n)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-c)/f,this._x=.25*f,this._y=(n+o)/f,this._z=(r+l)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-l)/f,this._x=(n+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-n)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let n=Math.min(1,e/i);return this.slerp(t,n),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,n=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=i*h+o*a+n*l-r*c,this._y=n*h+o*c+r*a-i*l,this._z=r*h+o*l+i*c-n*a,this._w=o*h-i*a-n*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,n=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,n=-n,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+i*e,this._y=this._y*c+n*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+n*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),n=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(n*Math.sin(t),n*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},D=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(su.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(su.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,n=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*n,this.y=r[1]*e+r[4]*i+r[7]*n,this.z=r[2]*e+r[5]*i+r[8]*n,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,n=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*n+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*n+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*n+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*n+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,n=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*n-a*i),h=2*(a*e-r*n),u=2*(r*i-o*e);return this.x=e+c*l+o*u-a*h,this.y=i+c*h+a*l-r*u,this.z=n+c*u+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,n=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*n,this.y=r[1]*e+r[5]*i+r[9]*n,this.z=r[2]*e+r[6]*i+r[10]*n,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,n=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=n*c-r*a,this.y=r*o-i*c,this.z=i*a-n*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Xc.copy(this).projectOnVector(t),this.sub(Xc)}reflect(t){return this.sub(Xc.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Wt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,n=this.z-t.z;return e*e+i*i+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let n=Math.sin(e)*t;return this.x=n*Math.sin(i),this.y=Math.cos(e)*t,this.z=n*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),n=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=n,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Xc=new D,su=new Ne,Ft=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,n,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,n,r,o,a,c,l)}set(t,e,i,n,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=n,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,n=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],u=i[7],d=i[2],f=i[5],g=i[8],x=n[0],p=n[3],m=n[6],S=n[1],C=n[4],b=n[7],A=n[2],E=n[5],_=n[8];return r[0]=o*x+a*S+c*A,r[3]=o*p+a*C+c*E,r[6]=o*m+a*b+c*_,r[1]=l*x+h*S+u*A,r[4]=l*p+h*C+u*E,r[7]=l*m+h*b+u*_,r[2]=d*x+f*S+g*A,r[5]=d*p+f*C+g*E,r[8]=d*m+f*b+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],n=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-i*r*h+i*a*c+n*r*l-n*o*c}invert(){let t=this.elements,e=t[0],i=t[1],n=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=h*o-a*l,d=a*c-h*r,f=l*r-o*c,g=e*u+i*d+n*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return t[0]=u*x,t[1]=(n*l-h*i)*x,t[2]=(a*i-n*o)*x,t[3]=d*x,t[4]=(h*e-n*c)*x,t[5]=(n*r-a*e)*x,t[6]=f*x,t[7]=(i*c-l*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,n,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-n*l,n*c,-n*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return Js("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(qc.makeScale(t,e)),this}rotate(t){return Js("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(qc.makeRotation(-t)),this}translate(t,e){return Js("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(qc.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let n=0;n<9;n++)if(e[n]!==i[n])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},qc=new Ft,ru=new Ft().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ou=new Ft().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function zp(){let s={enabled:!0,workingColorSpace:Un,spaces:{},convert:function(n,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===se&&(n.r=Ji(n.r),n.g=Ji(n.g),n.b=Ji(n.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(n.applyMatrix3(this.spaces[r].toXYZ),n.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===se&&(n.r=ms(n.r),n.g=ms(n.g),n.b=ms(n.b))),n},workingToColorSpace:function(n,r){return this.convert(n,this.workingColorSpace,r)},colorSpaceToWorking:function(n,r){return this.convert(n,r,this.workingColorSpace)},getPrimaries:function(n){return this.spaces[n].primaries},getTransfer:function(n){return n===sn?Qs:this.spaces[n].transfer},getToneMappingMode:function(n){return this.spaces[n].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(n,r=this.workingColorSpace){return n.fromArray(this.spaces[r].luminanceCoefficients)},define:function(n){Object.assign(this.spaces,n)},_getMatrix:function(n,r,o){return n.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(n){return this.spaces[n].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(n=this.workingColorSpace){return this.spaces[n].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return s.define({[Un]:{primaries:t,whitePoint:i,transfer:Qs,toXYZ:ru,fromXYZ:ou,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:oi},outputColorSpaceConfig:{drawingBufferColorSpace:oi}},[oi]:{primaries:t,whitePoint:i,transfer:se,toXYZ:ru,fromXYZ:ou,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:oi}}}),s}var $t=zp();function Ji(s){return s<.04045?s*.0773993808:Math.pow(s*.9478672986+.0521327014,2.4)}function ms(s){return s<.0031308?s*12.92:1.055*Math.pow(s,.41666)-.055}var ts,Go=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ts===void 0&&(ts=tr("canvas")),ts.width=t.width,ts.height=t.height;let n=ts.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),i=ts}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=tr("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let n=i.getImageData(0,0,t.width,t.height),r=n.data;for(let o=0;o<r.length;o++)r[o]=Ji(r[o]/255)*255;return i.putImageData(n,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Ji(e[i]/255)*255):e[i]=Ji(e[i]);return{data:e,width:t.width,height:t.height}}else return It("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Gp=0,vs=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Gp++}),this.uuid=Is(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},n=this.data;if(n!==null){let r;if(Array.isArray(n)){r=[];for(let o=0,a=n.length;o<a;o++)n[o].isDataTexture?r.push(Yc(n[o].image)):r.push(Yc(n[o]))}else r=Yc(n);i.url=r}return e||(t.images[this.uuid]=i),i}};function Yc(s){return typeof HTMLImageElement<"u"&&s instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&s instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&s instanceof ImageBitmap?Go.getDataURL(s):s.data?{data:Array.from(s.data),width:s.width,height:s.height,type:s.data.constructor.name}:(It("Texture: Unable to serialize Texture."),{})}var Vp=0,$c=new D,Je=class s extends Ai{constructor(t=s.DEFAULT_IMAGE,e=s.DEFAULT_MAPPING,i=Fi,n=Fi,r=Ze,o=en,a=Ii,c=ei,l=s.DEFAULT_ANISOTROPY,h=sn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Vp++}),this.uuid=Is(),this.name="",this.source=new vs(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=n,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Rt(0,0),this.repeat=new Rt(1,1),this.center=new Rt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ft,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize($c).x}get height(){return this.source.getSize($c).y}get depth(){return this.source.getSize($c).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){It(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let n=this[e];if(n===void 0){It(`Texture.setValues(): property '${e}' does not exist.`);continue}n&&i&&n.isVector2&&i.isVector2||n&&i&&n.isVector3&&i.isVector3||n&&i&&n.isMatrix3&&i.isMatrix3?n.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Fl)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Uo:t.x=t.x-Math.floor(t.x);break;case Fi:t.x=t.x<0?0:1;break;case ko:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Uo:t.y=t.y-Math.floor(t.y);break;case Fi:t.y=t.y<0?0:1;break;case ko:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Je.DEFAULT_IMAGE=null;Je.DEFAULT_MAPPING=Fl;Je.DEFAULT_ANISOTROPY=1;var me=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,n=1){this.x=t,this.y=e,this.z=i,this.w=n}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,n){return this.x=t,this.y=e,this.z=i,this.w=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,n=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*n+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*n+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*n+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*n+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,n,r,c=t.elements,l=c[0],h=c[4],u=c[8],d=c[1],f=c[5],g=c[9],x=c[2],p=c[6],m=c[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(g+p)<.1&&Math.abs(l+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let C=(l+1)/2,b=(f+1)/2,A=(m+1)/2,E=(h+d)/4,_=(u+x)/4,M=(g+p)/4;return C>b&&C>A?C<.01?(i=0,n=.707106781,r=.707106781):(i=Math.sqrt(C),n=E/i,r=_/i):b>A?b<.01?(i=.707106781,n=0,r=.707106781):(n=Math.sqrt(b),i=E/n,r=M/n):A<.01?(i=.707106781,n=.707106781,r=0):(r=Math.sqrt(A),i=_/r,n=M/r),this.set(i,n,r,e),this}let S=Math.sqrt((p-g)*(p-g)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(S)<.001&&(S=1),this.x=(p-g)/S,this.y=(u-x)/S,this.z=(d-h)/S,this.w=Math.acos((l+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Vo=class extends Ai{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ze,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new me(0,0,t,e),this.scissorTest=!1,this.viewport=new me(0,0,t,e),this.textures=[];let n=i.count;for(let r=0;r<n;r++)this.textures[r]=new Je({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ze,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let n=0,r=this.textures.length;n<r;n++)this.textures[n].image.width=t,this.textures[n].image.height=e,this.textures[n].image.depth=i,this.textures[n].isData3DTexture!==!0&&(this.textures[n].isArrayTexture=this.textures[n].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let n=Object.assign({},t.textures[e].image);this.textures[e].source=new vs(n)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ai=class extends Vo{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},er=class extends Je{constructor(t=null,e=1,i=1,n=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:n},this.magFilter=Le,this.minFilter=Le,this.wrapR=Fi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ho=class extends Je{constructor(t=null,e=1,i=1,n=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:n},this.magFilter=Le,this.minFilter=Le,this.wrapR=Fi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var re=class s{static{this.prototype.isMatrix4=!0}constructor(t,e,i,n,r,o,a,c,l,h,u,d,f,g,x,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,n,r,o,a,c,l,h,u,d,f,g,x,p)}set(t,e,i,n,r,o,a,c,l,h,u,d,f,g,x,p){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=n,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=g,m[11]=x,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new s().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,n=1/es.setFromMatrixColumn(t,0).length(),r=1/es.setFromMatrixColumn(t,1).length(),o=1/es.setFromMatrixColumn(t,2).length();return e[0]=i[0]*n,e[1]=i[1]*n,e[2]=i[2]*n,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,n=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(n),l=Math.sin(n),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,g=a*h,x=a*u;e[0]=c*h,e[4]=-c*u,e[8]=l,e[1]=f+g*l,e[5]=d-x*l,e[9]=-a*c,e[2]=x-d*l,e[6]=g+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*h,f=c*u,g=l*h,x=l*u;e[0]=d+x*a,e[4]=g*a-f,e[8]=o*l,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-g,e[6]=x+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*h,f=c*u,g=l*h,x=l*u;e[0]=d-x*a,e[4]=-o*u,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*h,f=o*u,g=a*h,x=a*u;e[0]=c*h,e[4]=g*l-f,e[8]=d*l+x,e[1]=c*u,e[5]=x*l+d,e[9]=f*l-g,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,g=a*c,x=a*l;e[0]=c*h,e[4]=x-d*u,e[8]=g*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=f*u+g,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*c,f=o*l,g=a*c,x=a*l;e[0]=c*h,e[4]=-u,e[8]=l*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-g,e[2]=g*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Hp,t,Wp)}lookAt(t,e,i){let n=this.elements;return si.subVectors(t,e),si.lengthSq()===0&&(si.z=1),si.normalize(),dn.crossVectors(i,si),dn.lengthSq()===0&&(Math.abs(i.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),dn.crossVectors(i,si)),dn.normalize(),to.crossVectors(si,dn),n[0]=dn.x,n[4]=to.x,n[8]=si.x,n[1]=dn.y,n[5]=to.y,n[9]=si.y,n[2]=dn.z,n[6]=to.z,n[10]=si.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,n=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],u=i[5],d=i[9],f=i[13],g=i[2],x=i[6],p=i[10],m=i[14],S=i[3],C=i[7],b=i[11],A=i[15],E=n[0],_=n[4],M=n[8],F=n[12],P=n[1],L=n[5],B=n[9],z=n[13],T=n[2],V=n[6],W=n[10],G=n[14],Q=n[3],X=n[7],J=n[11],tt=n[15];return r[0]=o*E+a*P+c*T+l*Q,r[4]=o*_+a*L+c*V+l*X,r[8]=o*M+a*B+c*W+l*J,r[12]=o*F+a*z+c*G+l*tt,r[1]=h*E+u*P+d*T+f*Q,r[5]=h*_+u*L+d*V+f*X,r[9]=h*M+u*B+d*W+f*J,r[13]=h*F+u*z+d*G+f*tt,r[2]=g*E+x*P+p*T+m*Q,r[6]=g*_+x*L+p*V+m*X,r[10]=g*M+x*B+p*W+m*J,r[14]=g*F+x*z+p*G+m*tt,r[3]=S*E+C*P+b*T+A*Q,r[7]=S*_+C*L+b*V+A*X,r[11]=S*M+C*B+b*W+A*J,r[15]=S*F+C*z+b*G+A*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],n=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],u=t[6],d=t[10],f=t[14],g=t[3],x=t[7],p=t[11],m=t[15],S=c*f-l*d,C=a*f-l*u,b=a*d-c*u,A=o*f-l*h,E=o*d-c*h,_=o*u-a*h;return e*(x*S-p*C+m*b)-i*(g*S-p*A+m*E)+n*(g*C-x*A+m*_)-r*(g*b-x*E+p*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],n=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-i*(r*h-a*c)+n*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let n=this.elements;return t.isVector3?(n[12]=t.x,n[13]=t.y,n[14]=t.z):(n[12]=t,n[13]=e,n[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],n=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=t[9],d=t[10],f=t[11],g=t[12],x=t[13],p=t[14],m=t[15],S=e*a-i*o,C=e*c-n*o,b=e*l-r*o,A=i*c-n*a,E=i*l-r*a,_=n*l-r*c,M=h*x-u*g,F=h*p-d*g,P=h*m-f*g,L=u*p-d*x,B=u*m-f*x,z=d*m-f*p,T=S*z-C*B+b*L+A*P-E*F+_*M;if(T===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/T;return t[0]=(a*z-c*B+l*L)*V,t[1]=(n*B-i*z-r*L)*V,t[2]=(x*_-p*E+m*A)*V,t[3]=(d*E-u*_-f*A)*V,t[4]=(c*P-o*z-l*F)*V,t[5]=(e*z-n*P+r*F)*V,t[6]=(p*b-g*_-m*C)*V,t[7]=(h*_-d*b+f*C)*V,t[8]=(o*B-a*P+l*M)*V,t[9]=(i*P-e*B-r*M)*V,t[10]=(g*E-x*b+m*S)*V,t[11]=(u*b-h*E-f*S)*V,t[12]=(a*F-o*L-c*M)*V,t[13]=(e*L-i*F+n*M)*V,t[14]=(x*C-g*A-p*S)*V,t[15]=(h*A-u*C+d*S)*V,this}scale(t){let e=this.elements,i=t.x,n=t.y,r=t.z;return e[0]*=i,e[4]*=n,e[8]*=r,e[1]*=i,e[5]*=n,e[9]*=r,e[2]*=i,e[6]*=n,e[10]*=r,e[3]*=i,e[7]*=n,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],n=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,n))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),n=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+i,l*a-n*c,l*c+n*a,0,l*a+n*c,h*a+i,h*c-n*o,0,l*c-n*a,h*c+n*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,n,r,o){return this.set(1,i,r,0,t,1,o,0,e,n,1,0,0,0,0,1),this}compose(t,e,i){let n=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,u=a+a,d=r*l,f=r*h,g=r*u,x=o*h,p=o*u,m=a*u,S=c*l,C=c*h,b=c*u,A=i.x,E=i.y,_=i.z;return n[0]=(1-(x+m))*A,n[1]=(f+b)*A,n[2]=(g-C)*A,n[3]=0,n[4]=(f-b)*E,n[5]=(1-(d+m))*E,n[6]=(p+S)*E,n[7]=0,n[8]=(g+C)*_,n[9]=(p-S)*_,n[10]=(1-(d+x))*_,n[11]=0,n[12]=t.x,n[13]=t.y,n[14]=t.z,n[15]=1,this}decompose(t,e,i){let n=this.elements;t.x=n[12],t.y=n[13],t.z=n[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=es.set(n[0],n[1],n[2]).length(),a=es.set(n[4],n[5],n[6]).length(),c=es.set(n[8],n[9],n[10]).length();r<0&&(o=-o),bi.copy(this);let l=1/o,h=1/a,u=1/c;return bi.elements[0]*=l,bi.elements[1]*=l,bi.elements[2]*=l,bi.elements[4]*=h,bi.elements[5]*=h,bi.elements[6]*=h,bi.elements[8]*=u,bi.elements[9]*=u,bi.elements[10]*=u,e.setFromRotationMatrix(bi),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,n,r,o,a=_i,c=!1){let l=this.elements,h=2*r/(e-t),u=2*r/(i-n),d=(e+t)/(e-t),f=(i+n)/(i-n),g,x;if(c)g=r/(o-r),x=o*r/(o-r);else if(a===_i)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===_s)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=x,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,n,r,o,a=_i,c=!1){let l=this.elements,h=2/(e-t),u=2/(i-n),d=-(e+t)/(e-t),f=-(i+n)/(i-n),g,x;if(c)g=1/(o-r),x=o/(o-r);else if(a===_i)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===_s)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=u,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=g,l[14]=x,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let n=0;n<16;n++)if(e[n]!==i[n])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},es=new D,bi=new re,Hp=new D(0,0,0),Wp=new D(1,1,1),dn=new D,to=new D,si=new D,au=new re,cu=new Ne,ji=class s{constructor(t=0,e=0,i=0,n=s.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=n}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,n=this._order){return this._x=t,this._y=e,this._z=i,this._order=n,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let n=t.elements,r=n[0],o=n[4],a=n[8],c=n[1],l=n[5],h=n[9],u=n[2],d=n[6],f=n[10];switch(e){case"XYZ":this._y=Math.asin(Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Wt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Wt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:It("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return au.makeRotationFromQuaternion(t),this.setFromRotationMatrix(au,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return cu.setFromEuler(this),this.setFromQuaternion(cu,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ji.DEFAULT_ORDER="XYZ";var Ss=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Xp=0,lu=new D,is=new Ne,Wi=new re,eo=new D,Hs=new D,qp=new D,Yp=new Ne,hu=new D(1,0,0),uu=new D(0,1,0),du=new D(0,0,1),fu={type:"added"},$p={type:"removed"},ns={type:"childadded",child:null},Zc={type:"childremoved",child:null},Fe=class s extends Ai{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Xp++}),this.uuid=Is(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=s.DEFAULT_UP.clone();let t=new D,e=new ji,i=new Ne,n=new D(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:n},modelViewMatrix:{value:new re},normalMatrix:{value:new Ft}}),this.matrix=new re,this.matrixWorld=new re,this.matrixAutoUpdate=s.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=s.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ss,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return is.setFromAxisAngle(t,e),this.quaternion.multiply(is),this}rotateOnWorldAxis(t,e){return is.setFromAxisAngle(t,e),this.quaternion.premultiply(is),this}rotateX(t){return this.rotateOnAxis(hu,t)}rotateY(t){return this.rotateOnAxis(uu,t)}rotateZ(t){return this.rotateOnAxis(du,t)}translateOnAxis(t,e){return lu.copy(t).applyQuaternion(this.quaternion),this.position.add(lu.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(hu,t)}translateY(t){return this.translateOnAxis(uu,t)}translateZ(t){return this.translateOnAxis(du,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Wi.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?eo.copy(t):eo.set(t,e,i);let n=this.parent;this.updateWorldMatrix(!0,!1),Hs.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Wi.lookAt(Hs,eo,this.up):Wi.lookAt(eo,Hs,this.up),this.quaternion.setFromRotationMatrix(Wi),n&&(Wi.extractRotation(n.matrixWorld),is.setFromRotationMatrix(Wi),this.quaternion.premultiply(is.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Lt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(fu),ns.child=t,this.dispatchEvent(ns),ns.child=null):Lt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent($p),Zc.child=t,this.dispatchEvent(Zc),Zc.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Wi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Wi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Wi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(fu),ns.child=t,this.dispatchEvent(ns),ns.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,n=this.children.length;i<n;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let n=this.children;for(let r=0,o=n.length;r<o;r++)n[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Hs,t,qp),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Hs,Yp,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,n=e.length;i<n;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,n=e.length;i<n;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,n=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*n,r[13]+=i-r[1]*e-r[5]*i-r[9]*n,r[14]+=n-r[2]*e-r[6]*i-r[10]*n}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,n=e.length;i<n;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let n={};n.uuid=this.uuid,n.type=this.type,n.name=this.name,n.castShadow=this.castShadow,n.receiveShadow=this.receiveShadow,n.visible=this.visible,n.frustumCulled=this.frustumCulled,n.renderOrder=this.renderOrder,n.static=this.static,n.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(n.userData=this.userData),n.layers=this.layers.mask,n.matrix=this.matrix.toArray(),n.up=this.up.toArray(),this.pivot!==null&&(n.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(n.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(n.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(n.type="InstancedMesh",n.count=this.count,n.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(n.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(n.type="BatchedMesh",n.perObjectFrustumCulled=this.perObjectFrustumCulled,n.sortObjects=this.sortObjects,n.drawRanges=this._drawRanges,n.reservedRanges=this._reservedRanges,n.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),n.instanceInfo=this._instanceInfo.map(a=>({...a})),n.availableInstanceIds=this._availableInstanceIds.slice(),n.availableGeometryIds=this._availableGeometryIds.slice(),n.nextIndexStart=this._nextIndexStart,n.nextVertexStart=this._nextVertexStart,n.geometryCount=this._geometryCount,n.maxInstanceCount=this._maxInstanceCount,n.maxVertexCount=this._maxVertexCount,n.maxIndexCount=this._maxIndexCount,n.geometryInitialized=this._geometryInitialized,n.matricesTexture=this._matricesTexture.toJSON(t),n.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(n.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(n.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(n.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?n.background=this.background.toJSON():this.background.isTexture&&(n.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(n.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){n.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(t.shapes,u)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(n.bindMode=this.bindMode,n.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),n.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));n.material=a}else n.material=r(t.materials,this.material);if(this.children.length>0){n.children=[];for(let a=0;a<this.children.length;a++)n.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){n.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];n.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=n,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let n=t.children[i];this.add(n.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Fe.DEFAULT_UP=new D(0,1,0);Fe.DEFAULT_MATRIX_AUTO_UPDATE=!0;Fe.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ht=class extends Fe{constructor(){super(),this.isGroup=!0,this.type="Group"}},Zp={type:"move"},Ms=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ht,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ht,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new D,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new D),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ht,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new D,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new D,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let n=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let x of t.hand.values()){let p=e.getJointPose(x,i),m=this._getHandJoint(l,x);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=l.joints["index-finger-tip"],u=l.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;l.inputState.pinching&&d>f+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(n=e.getPose(t.targetRaySpace,i),n===null&&r!==null&&(n=r),n!==null&&(a.matrix.fromArray(n.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,n.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(n.linearVelocity)):a.hasLinearVelocity=!1,n.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(n.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Zp)))}return a!==null&&(a.visible=n!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ht;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Md={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},fn={h:0,s:0,l:0},io={h:0,s:0,l:0};function Jc(s,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?s+(t-s)*6*e:e<1/2?t:e<2/3?s+(t-s)*6*(2/3-e):s}var At=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let n=t;n&&n.isColor?this.copy(n):typeof n=="number"?this.setHex(n):typeof n=="string"&&this.setStyle(n)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=oi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,$t.colorSpaceToWorking(this,e),this}setRGB(t,e,i,n=$t.workingColorSpace){return this.r=t,this.g=e,this.b=i,$t.colorSpaceToWorking(this,n),this}setHSL(t,e,i,n=$t.workingColorSpace){if(t=Yl(t,1),e=Wt(e,0,1),i=Wt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Jc(o,r,t+1/3),this.g=Jc(o,r,t),this.b=Jc(o,r,t-1/3)}return $t.colorSpaceToWorking(this,n),this}setStyle(t,e=oi){function i(r){r!==void 0&&parseFloat(r)<1&&It("Color: Alpha component of "+t+" will be ignored.")}let n;if(n=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=n[1],a=n[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:It("Color: Unknown color model "+t)}}else if(n=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=n[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);It("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=oi){let i=Md[t.toLowerCase()];return i!==void 0?this.setHex(i,e):It("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ji(t.r),this.g=Ji(t.g),this.b=Ji(t.b),this}copyLinearToSRGB(t){return this.r=ms(t.r),this.g=ms(t.g),this.b=ms(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=oi){return $t.workingToColorSpace(Ve.copy(this),t),Math.round(Wt(Ve.r*255,0,255))*65536+Math.round(Wt(Ve.g*255,0,255))*256+Math.round(Wt(Ve.b*255,0,255))}getHexString(t=oi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=$t.workingColorSpace){$t.workingToColorSpace(Ve.copy(this),e);let i=Ve.r,n=Ve.g,r=Ve.b,o=Math.max(i,n,r),a=Math.min(i,n,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case i:c=(n-r)/u+(n<r?6:0);break;case n:c=(r-i)/u+2;break;case r:c=(i-n)/u+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=$t.workingColorSpace){return $t.workingToColorSpace(Ve.copy(this),e),t.r=Ve.r,t.g=Ve.g,t.b=Ve.b,t}getStyle(t=oi){$t.workingToColorSpace(Ve.copy(this),t);let e=Ve.r,i=Ve.g,n=Ve.b;return t!==oi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${n.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(n*255)})`}offsetHSL(t,e,i){return this.getHSL(fn),this.setHSL(fn.h+t,fn.s+e,fn.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(fn),t.getHSL(io);let i=Ks(fn.h,io.h,e),n=Ks(fn.s,io.s,e),r=Ks(fn.l,io.l,e);return this.setHSL(i,n,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,n=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*n,this.g=r[1]*e+r[4]*i+r[7]*n,this.b=r[2]*e+r[5]*i+r[8]*n,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ve=new At;At.NAMES=Md;var ir=class extends Fe{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ji,this.environmentIntensity=1,this.environmentRotation=new ji,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},wi=new D,Xi=new D,Kc=new D,qi=new D,ss=new D,rs=new D,pu=new D,jc=new D,Qc=new D,tl=new D,el=new me,il=new me,nl=new me,Zi=class s{constructor(t=new D,e=new D,i=new D){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,n){n.subVectors(i,e),wi.subVectors(t,e),n.cross(wi);let r=n.lengthSq();return r>0?n.multiplyScalar(1/Math.sqrt(r)):n.set(0,0,0)}static getBarycoord(t,e,i,n,r){wi.subVectors(n,e),Xi.subVectors(i,e),Kc.subVectors(t,e);let o=wi.dot(wi),a=wi.dot(Xi),c=wi.dot(Kc),l=Xi.dot(Xi),h=Xi.dot(Kc),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(l*c-a*h)*d,g=(o*h-a*c)*d;return r.set(1-f-g,g,f)}static containsPoint(t,e,i,n){return this.getBarycoord(t,e,i,n,qi)===null?!1:qi.x>=0&&qi.y>=0&&qi.x+qi.y<=1}static getInterpolation(t,e,i,n,r,o,a,c){return this.getBarycoord(t,e,i,n,qi)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,qi.x),c.addScaledVector(o,qi.y),c.addScaledVector(a,qi.z),c)}static getInterpolatedAttribute(t,e,i,n,r,o){return el.setScalar(0),il.setScalar(0),nl.setScalar(0),el.fromBufferAttribute(t,e),il.fromBufferAttribute(t,i),nl.fromBufferAttribute(t,n),o.setScalar(0),o.addScaledVector(el,r.x),o.addScaledVector(il,r.y),o.addScaledVector(nl,r.z),o}static isFrontFacing(t,e,i,n){return wi.subVectors(i,e),Xi.subVectors(t,e),wi.cross(Xi).dot(n)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,n){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[n]),this}setFromAttributeAndIndices(t,e,i,n){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,n),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return wi.subVectors(this.c,this.b),Xi.subVectors(this.a,this.b),wi.cross(Xi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return s.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return s.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,n,r){return s.getInterpolation(t,this.a,this.b,this.c,e,i,n,r)}containsPoint(t){return s.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return s.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,n=this.b,r=this.c,o,a;ss.subVectors(n,i),rs.subVectors(r,i),jc.subVectors(t,i);let c=ss.dot(jc),l=rs.dot(jc);if(c<=0&&l<=0)return e.copy(i);Qc.subVectors(t,n);let h=ss.dot(Qc),u=rs.dot(Qc);if(h>=0&&u<=h)return e.copy(n);let d=c*u-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(i).addScaledVector(ss,o);tl.subVectors(t,r);let f=ss.dot(tl),g=rs.dot(tl);if(g>=0&&f<=g)return e.copy(r);let x=f*l-c*g;if(x<=0&&l>=0&&g<=0)return a=l/(l-g),e.copy(i).addScaledVector(rs,a);let p=h*g-f*u;if(p<=0&&u-h>=0&&f-g>=0)return pu.subVectors(r,n),a=(u-h)/(u-h+(f-g)),e.copy(n).addScaledVector(pu,a);let m=1/(p+x+d);return o=x*m,a=d*m,e.copy(i).addScaledVector(ss,o).addScaledVector(rs,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},xi=class{constructor(t=new D(1/0,1/0,1/0),e=new D(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ei.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ei.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ei.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ei):Ei.fromBufferAttribute(r,o),Ei.applyMatrix4(t.matrixWorld),this.expandByPoint(Ei);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),no.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),no.copy(i.boundingBox)),no.applyMatrix4(t.matrixWorld),this.union(no)}let n=t.children;for(let r=0,o=n.length;r<o;r++)this.expandByObject(n[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ei),Ei.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ws),so.subVectors(this.max,Ws),os.subVectors(t.a,Ws),as.subVectors(t.b,Ws),cs.subVectors(t.c,Ws),pn.subVectors(as,os),mn.subVectors(cs,as),Nn.subVectors(os,cs);let e=[0,-pn.z,pn.y,0,-mn.z,mn.y,0,-Nn.z,Nn.y,pn.z,0,-pn.x,mn.z,0,-mn.x,Nn.z,0,-Nn.x,-pn.y,pn.x,0,-mn.y,mn.x,0,-Nn.y,Nn.x,0];return!sl(e,os,as,cs,so)||(e=[1,0,0,0,1,0,0,0,1],!sl(e,os,as,cs,so))?!1:(ro.crossVectors(pn,mn),e=[ro.x,ro.y,ro.z],sl(e,os,as,cs,so))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ei).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ei).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Yi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Yi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Yi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Yi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Yi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Yi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Yi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Yi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Yi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Yi=[new D,new D,new D,new D,new D,new D,new D,new D],Ei=new D,no=new xi,os=new D,as=new D,cs=new D,pn=new D,mn=new D,Nn=new D,Ws=new D,so=new D,ro=new D,Fn=new D;function sl(s,t,e,i,n){for(let r=0,o=s.length-3;r<=o;r+=3){Fn.fromArray(s,r);let a=n.x*Math.abs(Fn.x)+n.y*Math.abs(Fn.y)+n.z*Math.abs(Fn.z),c=t.dot(Fn),l=e.dot(Fn),h=i.dot(Fn);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Se=new D,oo=new Rt,Jp=0,ee=class extends Ai{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Jp++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=md,this.updateRanges=[],this.gpuType=yi,this.version=0,this._normalizationScale=t!==void 0?Zl(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let n=0,r=this.itemSize;n<r;n++)this.array[t+n]=e.array[i+n];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)oo.fromBufferAttribute(this,e),oo.applyMatrix3(t),this.setXY(e,oo.x,oo.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Se.fromBufferAttribute(this,e),Se.applyMatrix3(t),this.setXYZ(e,Se.x,Se.y,Se.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Se.fromBufferAttribute(this,e),Se.applyMatrix4(t),this.setXYZ(e,Se.x,Se.y,Se.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Se.fromBufferAttribute(this,e),Se.applyNormalMatrix(t),this.setXYZ(e,Se.x,Se.y,Se.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Se.fromBufferAttribute(this,e),Se.transformDirection(t),this.setXYZ(e,Se.x,Se.y,Se.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=n,this}setXYZW(t,e,i,n,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),n=this._normalize(n),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=n,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):vd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Sd(t,this.array)}};var nr=class extends ee{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var sr=class extends ee{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var oe=class extends ee{constructor(t,e,i){super(new Float32Array(t),e,i)}},Kp=new xi,Xs=new D,rl=new D,Bi=class{constructor(t=new D,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Kp.setFromPoints(t).getCenter(i);let n=0;for(let r=0,o=t.length;r<o;r++)n=Math.max(n,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(n),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Xs.subVectors(t,this.center);let e=Xs.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),n=(i-this.radius)*.5;this.center.addScaledVector(Xs,n/i),this.radius+=n}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(rl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Xs.copy(t.center).add(rl)),this.expandByPoint(Xs.copy(t.center).sub(rl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},jp=0,gi=new re,ol=new Fe,ls=new D,ri=new xi,qs=new xi,De=new D,Kt=class s extends Ai{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:jp++}),this.uuid=Is(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(bp(t)?sr:nr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ft().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let n=this.attributes.tangent;return n!==void 0&&(n.transformDirection(t),n.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return gi.makeRotationFromQuaternion(t),this.applyMatrix4(gi),this}rotateX(t){return gi.makeRotationX(t),this.applyMatrix4(gi),this}rotateY(t){return gi.makeRotationY(t),this.applyMatrix4(gi),this}rotateZ(t){return gi.makeRotationZ(t),this.applyMatrix4(gi),this}translate(t,e,i){return gi.makeTranslation(t,e,i),this.applyMatrix4(gi),this}scale(t,e,i){return gi.makeScale(t,e,i),this.applyMatrix4(gi),this}lookAt(t){return ol.lookAt(t),ol.updateMatrix(),this.applyMatrix4(ol.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ls).negate(),this.translate(ls.x,ls.y,ls.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let n=0,r=t.length;n<r;n++){let o=t[n];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new oe(i,3))}else{let i=Math.min(t.length,e.count);for(let n=0;n<i;n++){let r=t[n];e.setXYZ(n,r.x,r.y,r.z||0)}t.length>e.count&&It("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Lt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new D(-1/0,-1/0,-1/0),new D(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,n=e.length;i<n;i++){let r=e[i];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(De.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(De),De.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(De)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Lt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Bi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Lt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new D,1/0);return}if(t){let i=this.boundingSphere.center;if(ri.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];qs.setFromBufferAttribute(a),this.morphTargetsRelative?(De.addVectors(ri.min,qs.min),ri.expandByPoint(De),De.addVectors(ri.max,qs.max),ri.expandByPoint(De)):(ri.expandByPoint(qs.min),ri.expandByPoint(qs.max))}ri.getCenter(i);let n=0;for(let r=0,o=t.count;r<o;r++)De.fromBufferAttribute(t,r),n=Math.max(n,i.distanceToSquared(De));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)De.fromBufferAttribute(a,l),c&&(ls.fromBufferAttribute(t,l),De.add(ls)),n=Math.max(n,i.distanceToSquared(De))}this.boundingSphere.radius=Math.sqrt(n),isNaN(this.boundingSphere.radius)&&Lt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Lt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,n=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ee(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let F=0;F<i.count;F++)a[F]=new D,c[F]=new D;let h=new D,u=new D,d=new D,f=new Rt,g=new Rt,x=new Rt,p=new D,m=new D;function S(F,P,L){l[F]=l[P]=l[L]=1,h.fromBufferAttribute(i,F),u.fromBufferAttribute(i,P),d.fromBufferAttribute(i,L),f.fromBufferAttribute(r,F),g.fromBufferAttribute(r,P),x.fromBufferAttribute(r,L),u.sub(h),d.sub(h),g.sub(f),x.sub(f);let B=1/(g.x*x.y-x.x*g.y);isFinite(B)&&(p.copy(u).multiplyScalar(x.y).addScaledVector(d,-g.y).multiplyScalar(B),m.copy(d).multiplyScalar(g.x).addScaledVector(u,-x.x).multiplyScalar(B),a[F].add(p),a[P].add(p),a[L].add(p),c[F].add(m),c[P].add(m),c[L].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:t.count}]);for(let F=0,P=C.length;F<P;++F){let L=C[F],B=L.start,z=L.count;for(let T=B,V=B+z;T<V;T+=3)S(t.getX(T+0),t.getX(T+1),t.getX(T+2))}let b=new D,A=new D,E=new D,_=new D;function M(F){E.fromBufferAttribute(n,F),_.copy(E);let P=a[F];b.copy(P),b.sub(E.multiplyScalar(E.dot(P))).normalize(),A.crossVectors(_,P);let B=A.dot(c[F])<0?-1:1;o.setXYZW(F,b.x,b.y,b.z,B)}for(let F=0,P=i.count;F<P;++F)l[F]&&M(F);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new ee(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let n=new D,r=new D,o=new D,a=new D,c=new D,l=new D,h=new D,u=new D;if(t)for(let d=0,f=t.count;d<f;d+=3){let g=t.getX(d+0),x=t.getX(d+1),p=t.getX(d+2);n.fromBufferAttribute(e,g),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,p),h.subVectors(o,r),u.subVectors(n,r),h.cross(u),a.fromBufferAttribute(i,g),c.fromBufferAttribute(i,x),l.fromBufferAttribute(i,p),a.add(h),c.add(h),l.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(x,c.x,c.y,c.z),i.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)n.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(n,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)De.fromBufferAttribute(t,e),De.normalize(),t.setXYZ(e,De.x,De.y,De.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,u=a.normalized,d=new l.constructor(c.length*h),f=0,g=0;for(let x=0,p=c.length;x<p;x++){a.isInterleavedBufferAttribute?f=c[x]*a.data.stride+a.offset:f=c[x]*h;for(let m=0;m<h;m++)d[g++]=l[f++]}return new ee(d,h,u)}if(this.index===null)return It("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new s,i=this.index.array,n=this.attributes;for(let a in n){let c=n[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<u;h++){let d=l[h],f=t(d,i);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let n={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,d=l.length;u<d;u++){let f=l[u];h.push(f.toJSON(t.data))}h.length>0&&(n[c]=h,r=!0)}r&&(t.data.morphAttributes=n,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let n=t.attributes;for(let l in n){let h=n[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],u=r[l];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var al=new D,Qp=new D,tm=new Ft,Ye=class{constructor(t=new D(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,n){return this.normal.set(t,e,i),this.constant=n,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let n=al.subVectors(i,e).cross(Qp.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(n,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let n=t.delta(al),r=this.normal.dot(n);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(n,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||tm.getNormalMatrix(t),n=this.coplanarPoint(al).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-n.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},em=0,Ti=class extends Ai{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:em++}),this.uuid=Is(),this.name="",this.type="Material",this.blending=Cs,this.side=An,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Al,this.blendDst=Tl,this.blendEquation=Xn,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new At(0,0,0),this.blendAlpha=0,this.depthFunc=gs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ld,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Po,this.stencilZFail=Po,this.stencilZPass=Po,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){It(`Material: parameter '${e}' has value of undefined.`);continue}let n=this[e];if(n===void 0){It(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}n&&n.isColor?n.set(i):n&&n.isVector2&&i&&i.isVector2||n&&n.isEuler&&i&&i.isEuler||n&&n.isVector3&&i&&i.isVector3?n.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function n(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=n(t.textures),o=n(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new At().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Ye().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Rt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Rt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let n=e.length;i=new Array(n);for(let r=0;r!==n;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var $i=new D,cl=new D,ao=new D,co=new D,Qi=class{constructor(t=new D,e=new D(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,$i)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=$i.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):($i.copy(this.origin).addScaledVector(this.direction,e),$i.distanceToSquared(t))}distanceSqToSegment(t,e,i,n){cl.copy(t).add(e).multiplyScalar(.5),ao.copy(e).sub(t).normalize(),co.copy(this.origin).sub(cl);let r=t.distanceTo(e)*.5,o=-this.direction.dot(ao),a=co.dot(this.direction),c=-co.dot(ao),l=co.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*c-a,d=o*a-c,g=r*h,u>=0)if(d>=-g)if(d<=g){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*c)+l}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l):d<=g?(u=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,u),n&&n.copy(cl).addScaledVector(ao,d),f}intersectSphere(t,e){if(t.radius<0)return null;$i.subVectors(t.center,this.origin);let i=$i.dot(this.direction),n=$i.dot($i)-i*i,r=t.radius*t.radius;if(n>r)return null;let o=Math.sqrt(r-n),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,n,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return l>=0?(i=(t.min.x-d.x)*l,n=(t.max.x-d.x)*l):(i=(t.max.x-d.x)*l,n=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),i>o||r>n||((r>i||isNaN(i))&&(i=r),(o<n||isNaN(n))&&(n=o),u>=0?(a=(t.min.z-d.z)*u,c=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,c=(t.min.z-d.z)*u),i>c||a>n)||((a>i||i!==i)&&(i=a),(c<n||n!==n)&&(n=c),n<0)?null:this.at(i>=0?i:n,e)}intersectsBox(t){return this.intersectBox(t,$i)!==null}intersectTriangle(t,e,i,n,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,g=e.x-o.x,x=e.y-o.y,p=e.z-o.z,m=i.x-o.x,S=i.y-o.y,C=i.z-o.z,b=Math.abs(c),A=Math.abs(l),E=Math.abs(h),_,M,F,P,L,B,z,T,V,W,G,Q;if(b>=A&&b>=E?(F=c,B=u,V=g,Q=m,c>=0?(_=l,M=h,P=d,L=f,z=x,T=p,W=S,G=C):(_=h,M=l,P=f,L=d,z=p,T=x,W=C,G=S)):A>=E?(F=l,B=d,V=x,Q=S,l>=0?(_=h,M=c,P=f,L=u,z=p,T=g,W=C,G=m):(_=c,M=h,P=u,L=f,z=g,T=p,W=m,G=C)):(F=h,B=f,V=p,Q=C,h>=0?(_=c,M=l,P=u,L=d,z=g,T=x,W=m,G=S):(_=l,M=c,P=d,L=u,z=x,T=g,W=S,G=m)),F===0)return null;let X=_/F,J=M/F,tt=1/F,yt=P-X*B,Tt=L-J*B,Y=z-X*V,dt=T-J*V,et=W-X*Q,xt=G-J*Q,ft=et*dt-xt*Y,Nt=yt*xt-Tt*et,ge=Y*Tt-dt*yt;if(n){if(ft<0||Nt<0||ge<0)return null}else if((ft<0||Nt<0||ge<0)&&(ft>0||Nt>0||ge>0))return null;let Pt=ft+Nt+ge;if(Pt===0)return null;let jt=tt*(ft*B+Nt*V+ge*Q);return(Pt>0?jt<0:jt>0)?null:this.at(jt/Pt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ci=class extends Ti{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new At(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ji,this.combine=ca,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},mu=new re,Bn=new Qi,lo=new Bi,gu=new D,ho=new D,uo=new D,fo=new D,ll=new D,po=new D,_u=new D,mo=new D,Me=class extends Fe{constructor(t=new Kt,e=new ci){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let n=e[i[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=n.length;r<o;r++){let a=n[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,n=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(n,t);let a=this.morphTargetInfluences;if(r&&a){po.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(ll.fromBufferAttribute(u,t),o?po.addScaledVector(ll,h):po.addScaledVector(ll.sub(e),h))}e.add(po)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,n=this.material,r=this.matrixWorld;n!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),lo.copy(i.boundingSphere),lo.applyMatrix4(r),Bn.copy(t.ray).recast(t.near),!(lo.containsPoint(Bn.origin)===!1&&(Bn.intersectSphere(lo,gu)===null||Bn.origin.distanceToSquared(gu)>(t.far-t.near)**2))&&(mu.copy(r).invert(),Bn.copy(t.ray).applyMatrix4(mu),!(i.boundingBox!==null&&Bn.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Bn)))}_computeIntersections(t,e,i){let n,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=d.length;g<x;g++){let p=d[g],m=o[p.materialIndex],S=Math.max(p.start,f.start),C=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let b=S,A=C;b<A;b+=3){let E=a.getX(b),_=a.getX(b+1),M=a.getX(b+2);n=go(this,m,t,i,l,h,u,E,_,M),n&&(n.faceIndex=Math.floor(b/3),n.face.materialIndex=p.materialIndex,e.push(n))}}else{let g=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let p=g,m=x;p<m;p+=3){let S=a.getX(p),C=a.getX(p+1),b=a.getX(p+2);n=go(this,o,t,i,l,h,u,S,C,b),n&&(n.faceIndex=Math.floor(p/3),e.push(n))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,x=d.length;g<x;g++){let p=d[g],m=o[p.materialIndex],S=Math.max(p.start,f.start),C=Math.min(c.count,Math.min(p.start+p.count,f.start+f.count));for(let b=S,A=C;b<A;b+=3){let E=b,_=b+1,M=b+2;n=go(this,m,t,i,l,h,u,E,_,M),n&&(n.faceIndex=Math.floor(b/3),n.face.materialIndex=p.materialIndex,e.push(n))}}else{let g=Math.max(0,f.start),x=Math.min(c.count,f.start+f.count);for(let p=g,m=x;p<m;p+=3){let S=p,C=p+1,b=p+2;n=go(this,o,t,i,l,h,u,S,C,b),n&&(n.faceIndex=Math.floor(p/3),e.push(n))}}}};function im(s,t,e,i,n,r,o,a){let c;if(t.side===Ke?c=i.intersectTriangle(o,r,n,!0,a):c=i.intersectTriangle(n,r,o,t.side===An,a),c===null)return null;mo.copy(a),mo.applyMatrix4(s.matrixWorld);let l=e.ray.origin.distanceTo(mo);return l<e.near||l>e.far?null:{distance:l,point:mo.clone(),object:s}}function go(s,t,e,i,n,r,o,a,c,l){s.getVertexPosition(a,ho),s.getVertexPosition(c,uo),s.getVertexPosition(l,fo);let h=im(s,t,e,i,ho,uo,fo,_u);if(h){let u=new D;Zi.getBarycoord(_u,ho,uo,fo,u),n&&(h.uv=Zi.getInterpolatedAttribute(n,a,c,l,u,new Rt)),r&&(h.uv1=Zi.getInterpolatedAttribute(r,a,c,l,u,new Rt)),o&&(h.normal=Zi.getInterpolatedAttribute(o,a,c,l,u,new D),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new D,materialIndex:0};Zi.getNormal(ho,uo,fo,d.normal),h.face=d,h.barycoord=u}return h}var rr=class extends Je{constructor(t=null,e=1,i=1,n,r,o,a,c,l=Le,h=Le,u,d){super(null,o,a,c,l,h,n,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ci=class extends ee{constructor(t,e,i,n=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},hs=new re,xu=new re,_o=[],yu=new xi,nm=new re,Ys=new Me,$s=new Bi,or=class extends Me{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Ci(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let n=0;n<i;n++)this.setMatrixAt(n,nm)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new xi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,hs),yu.copy(t.boundingBox).applyMatrix4(hs),this.boundingBox.union(yu)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Bi),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,hs),$s.copy(t.boundingSphere).applyMatrix4(hs),this.boundingSphere.union($s)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,n=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=n[o+a]}raycast(t,e){let i=this.matrixWorld,n=this.count;if(Ys.geometry=this.geometry,Ys.material=this.material,Ys.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),$s.copy(this.boundingSphere),$s.applyMatrix4(i),t.ray.intersectsSphere($s)!==!1))for(let r=0;r<n;r++){this.getMatrixAt(r,hs),xu.multiplyMatrices(i,hs),Ys.matrixWorld=xu,Ys.raycast(t,_o);for(let o=0,a=_o.length;o<a;o++){let c=_o[o];c.instanceId=r,c.object=this,e.push(c)}_o.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Ci(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,n=i.length+1;this.morphTexture===null&&(this.morphTexture=new rr(new Float32Array(n*this.count),n,this.count,ma,yi));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=n*t;return r[c]=a,r.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},On=new Bi,sm=new Rt(.5,.5),xo=new D,_n=class{constructor(t=new Ye,e=new Ye,i=new Ye,n=new Ye,r=new Ye,o=new Ye){this.planes=[t,e,i,n,r,o]}set(t,e,i,n,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(n),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=_i,i=!1){let n=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],x=r[9],p=r[10],m=r[11],S=r[12],C=r[13],b=r[14],A=r[15];if(n[0].setComponents(l-o,f-h,m-g,A-S).normalize(),n[1].setComponents(l+o,f+h,m+g,A+S).normalize(),n[2].setComponents(l+a,f+u,m+x,A+C).normalize(),n[3].setComponents(l-a,f-u,m-x,A-C).normalize(),i)n[4].setComponents(c,d,p,b).normalize(),n[5].setComponents(l-c,f-d,m-p,A-b).normalize();else if(n[4].setComponents(l-c,f-d,m-p,A-b).normalize(),e===_i)n[5].setComponents(l+c,f+d,m+p,A+b).normalize();else if(e===_s)n[5].setComponents(c,d,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),On.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),On.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(On)}intersectsSprite(t){On.center.set(0,0,0);let e=sm.distanceTo(t.center);return On.radius=.7071067811865476+e,On.applyMatrix4(t.matrixWorld),this.intersectsSphere(On)}intersectsSphere(t){let e=this.planes,i=t.center,n=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<n)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let n=e[i];if(xo.x=n.normal.x>0?t.max.x:t.min.x,xo.y=n.normal.y>0?t.max.y:t.min.y,xo.z=n.normal.z>0?t.max.z:t.min.z,n.distanceToPoint(xo)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},vu=new re,Wo=class s{constructor(){this.coordinateSystem=_i,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let n=0;n<e.length;n++){let r=e[n];vu.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[n]===void 0&&(i[n]=new _n),i[n].setFromProjectionMatrix(vu,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let n=0;n<t._count;n++)e[n]===void 0&&(e[n]=new _n),e[n].copy(i[n]);return this._count=t._count,this}clone(){return new s().copy(this)}};var ye=class extends Ti{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new At(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Xo=new D,qo=new D,Su=new re,Zs=new Qi,yo=new Bi,hl=new D,Mu=new D,bs=class extends Fe{constructor(t=new Kt,e=new ye){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let n=1,r=e.count;n<r;n++)Xo.fromBufferAttribute(e,n-1),qo.fromBufferAttribute(e,n),i[n]=i[n-1],i[n]+=Xo.distanceTo(qo);t.setAttribute("lineDistance",new oe(i,1))}else It("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,n=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),yo.copy(i.boundingSphere),yo.applyMatrix4(n),yo.radius+=r,t.ray.intersectsSphere(yo)===!1)return;Su.copy(n).invert(),Zs.copy(t.ray).applyMatrix4(Su);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=f,p=g-1;x<p;x+=l){let m=h.getX(x),S=h.getX(x+1),C=vo(this,t,Zs,c,m,S,x);C&&e.push(C)}if(this.isLineLoop){let x=h.getX(g-1),p=h.getX(f),m=vo(this,t,Zs,c,x,p,g-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let x=f,p=g-1;x<p;x+=l){let m=vo(this,t,Zs,c,x,x+1,x);m&&e.push(m)}if(this.isLineLoop){let x=vo(this,t,Zs,c,g-1,f,g-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let n=e[i[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=n.length;r<o;r++){let a=n[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function vo(s,t,e,i,n,r,o){let a=s.geometry.attributes.position;if(Xo.fromBufferAttribute(a,n),qo.fromBufferAttribute(a,r),e.distanceSqToSegment(Xo,qo,hl,Mu)>i)return;hl.applyMatrix4(s.matrixWorld);let l=t.ray.origin.distanceTo(hl);if(!(l<t.near||l>t.far))return{distance:l,point:Mu.clone().applyMatrix4(s.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:s}}var bu=new D,wu=new D,Ue=class extends bs{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let n=0,r=e.count;n<r;n+=2)bu.fromBufferAttribute(e,n),wu.fromBufferAttribute(e,n+1),i[n]=n===0?0:i[n-1],i[n+1]=i[n]+bu.distanceTo(wu);t.setAttribute("lineDistance",new oe(i,1))}else It("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var xn=class extends Ti{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new At(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Eu=new re,_l=new Qi,So=new Bi,Mo=new D,kn=class extends Fe{constructor(t=new Kt,e=new xn){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,n=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),So.copy(i.boundingSphere),So.applyMatrix4(n),So.radius+=r,t.ray.intersectsSphere(So)===!1)return;Eu.copy(n).invert(),_l.copy(t.ray).applyMatrix4(Eu);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=i.index,u=i.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let g=d,x=f;g<x;g++){let p=l.getX(g);Mo.fromBufferAttribute(u,p),Au(Mo,p,c,n,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let g=d,x=f;g<x;g++)Mo.fromBufferAttribute(u,g),Au(Mo,g,c,n,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let n=e[i[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=n.length;r<o;r++){let a=n[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Au(s,t,e,i,n,r,o){let a=_l.distanceSqToPoint(s);if(a<e){let c=new D;_l.closestPointToPoint(s,c),c.applyMatrix4(i);let l=n.ray.origin.distanceTo(c);if(l<n.near||l>n.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var ar=class extends Je{constructor(t=[],e=qn,i,n,r,o,a,c,l,h){super(t,e,i,n,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},cr=class extends Je{constructor(t,e,i,n,r,o,a,c,l){super(t,e,i,n,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var tn=class extends Je{constructor(t,e,i=Ri,n,r,o,a=Le,c=Le,l,h=Ki,u=1){if(h!==Ki&&h!==nn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,n,r,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new vs(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},lr=class extends tn{constructor(t,e=Ri,i=qn,n,r,o=Le,a=Le,c,l=Ki){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,n,r,o,a,c,l),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},hr=class extends Je{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},yn=class s extends Kt{constructor(t=1,e=1,i=1,n=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:n,heightSegments:r,depthSegments:o};let a=this;n=Math.floor(n),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,n,o,2),g("x","z","y",1,-1,t,i,-e,n,o,3),g("x","y","z",1,-1,t,e,i,n,r,4),g("x","y","z",-1,-1,t,e,-i,n,r,5),this.setIndex(c),this.setAttribute("position",new oe(l,3)),this.setAttribute("normal",new oe(h,3)),this.setAttribute("uv",new oe(u,2));function g(x,p,m,S,C,b,A,E,_,M,F){let P=b/_,L=A/M,B=b/2,z=A/2,T=E/2,V=_+1,W=M+1,G=0,Q=0,X=new D;for(let J=0;J<W;J++){let tt=J*L-z;for(let yt=0;yt<V;yt++){let Tt=yt*P-B;X[x]=Tt*S,X[p]=tt*C,X[m]=T,l.push(X.x,X.y,X.z),X[x]=0,X[p]=0,X[m]=E>0?1:-1,h.push(X.x,X.y,X.z),u.push(yt/_),u.push(1-J/M),G+=1}}for(let J=0;J<M;J++)for(let tt=0;tt<_;tt++){let yt=d+tt+V*J,Tt=d+tt+V*(J+1),Y=d+(tt+1)+V*(J+1),dt=d+(tt+1)+V*J;c.push(yt,Tt,dt),c.push(Tt,Y,dt),Q+=6}a.addGroup(f,Q,F),f+=Q,d+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var zn=class s extends Kt{constructor(t=1,e=32,i=0,n=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:n},e=Math.max(3,e);let r=[],o=[],a=[],c=[],l=new D,h=new Rt;o.push(0,0,0),a.push(0,0,1),c.push(.5,.5);for(let u=0,d=3;u<=e;u++,d+=3){let f=i+u/e*n;l.x=t*Math.cos(f),l.y=t*Math.sin(f),o.push(l.x,l.y,l.z),a.push(0,0,1),h.x=(o[d]/t+1)/2,h.y=(o[d+1]/t+1)/2,c.push(h.x,h.y)}for(let u=1;u<=e;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new oe(o,3)),this.setAttribute("normal",new oe(a,3)),this.setAttribute("uv",new oe(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radius,t.segments,t.thetaStart,t.thetaLength)}},vn=class s extends Kt{constructor(t=1,e=1,i=1,n=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:n,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;n=Math.floor(n),r=Math.floor(r);let h=[],u=[],d=[],f=[],g=0,x=[],p=i/2,m=0;S(),o===!1&&(t>0&&C(!0),e>0&&C(!1)),this.setIndex(h),this.setAttribute("position",new oe(u,3)),this.setAttribute("normal",new oe(d,3)),this.setAttribute("uv",new oe(f,2));function S(){let b=new D,A=new D,E=0,_=(e-t)/i;for(let M=0;M<=r;M++){let F=[],P=M/r,L=P*(e-t)+t;for(let B=0;B<=n;B++){let z=B/n,T=z*c+a,V=Math.sin(T),W=Math.cos(T);A.x=L*V,A.y=-P*i+p,A.z=L*W,u.push(A.x,A.y,A.z),b.set(V,_,W).normalize(),d.push(b.x,b.y,b.z),f.push(z,1-P),F.push(g++)}x.push(F)}for(let M=0;M<n;M++)for(let F=0;F<r;F++){let P=x[F][M],L=x[F+1][M],B=x[F+1][M+1],z=x[F][M+1];(t>0||F!==0)&&(h.push(P,L,z),E+=3),(e>0||F!==r-1)&&(h.push(L,B,z),E+=3)}l.addGroup(m,E,0),m+=E}function C(b){let A=g,E=new Rt,_=new D,M=0,F=b===!0?t:e,P=b===!0?1:-1;for(let B=1;B<=n;B++)u.push(0,p*P,0),d.push(0,P,0),f.push(.5,.5),g++;let L=g;for(let B=0;B<=n;B++){let T=B/n*c+a,V=Math.cos(T),W=Math.sin(T);_.x=F*W,_.y=p*P,_.z=F*V,u.push(_.x,_.y,_.z),d.push(0,P,0),E.x=V*.5+.5,E.y=W*.5*P+.5,f.push(E.x,E.y),g++}for(let B=0;B<n;B++){let z=A+B,T=L+B;b===!0?h.push(T,T+1,z):h.push(T+1,T,z),M+=3}l.addGroup(m,M,b===!0?1:2),m+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ur=class s extends vn{constructor(t=1,e=1,i=32,n=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,n,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:n,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new s(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var bo=new D,wo=new D,ul=new D,Eo=new Zi,dr=class extends Kt{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let n=Math.pow(10,4),r=Math.cos(ps*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let g=0;g<c;g+=3){o?(l[0]=o.getX(g),l[1]=o.getX(g+1),l[2]=o.getX(g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:x,b:p,c:m}=Eo;if(x.fromBufferAttribute(a,l[0]),p.fromBufferAttribute(a,l[1]),m.fromBufferAttribute(a,l[2]),Eo.getNormal(ul),u[0]=`${Math.round(x.x*n)},${Math.round(x.y*n)},${Math.round(x.z*n)}`,u[1]=`${Math.round(p.x*n)},${Math.round(p.y*n)},${Math.round(p.z*n)}`,u[2]=`${Math.round(m.x*n)},${Math.round(m.y*n)},${Math.round(m.z*n)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let S=0;S<3;S++){let C=(S+1)%3,b=u[S],A=u[C],E=Eo[h[S]],_=Eo[h[C]],M=`${b}_${A}`,F=`${A}_${b}`,P=d.get(F);P?(ul.dot(P.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(_.x,_.y,_.z)),d.set(F,null)):d.has(M)||d.set(M,{index0:l[S],index1:l[C],normal:ul.clone()})}}for(let g of d.values())if(g){let{index0:x,index1:p}=g;bo.fromBufferAttribute(a,x),wo.fromBufferAttribute(a,p),f.push(bo.x,bo.y,bo.z),f.push(wo.x,wo.y,wo.z)}this.setAttribute("position",new oe(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var fr=class s extends Kt{constructor(t=1,e=1,i=1,n=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:n};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(n),l=a+1,h=c+1,u=t/a,d=e/c,f=[],g=[],x=[],p=[];for(let m=0;m<h;m++){let S=m*d-o;for(let C=0;C<l;C++){let b=C*u-r;g.push(b,-S,0),x.push(0,0,1),p.push(C/a),p.push(1-m/c)}}for(let m=0;m<c;m++)for(let S=0;S<a;S++){let C=S+l*m,b=S+l*(m+1),A=S+1+l*(m+1),E=S+1+l*m;f.push(C,b,E),f.push(b,A,E)}this.setIndex(f),this.setAttribute("position",new oe(g,3)),this.setAttribute("normal",new oe(x,3)),this.setAttribute("uv",new oe(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.width,t.height,t.widthSegments,t.heightSegments)}},pr=class s extends Kt{constructor(t=.5,e=1,i=32,n=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:i,phiSegments:n,thetaStart:r,thetaLength:o},i=Math.max(3,i),n=Math.max(1,n);let a=[],c=[],l=[],h=[],u=t,d=(e-t)/n,f=new D,g=new Rt;for(let x=0;x<=n;x++){for(let p=0;p<=i;p++){let m=r+p/i*o;f.x=u*Math.cos(m),f.y=u*Math.sin(m),c.push(f.x,f.y,f.z),l.push(0,0,1),g.x=(f.x/e+1)/2,g.y=(f.y/e+1)/2,h.push(g.x,g.y)}u+=d}for(let x=0;x<n;x++){let p=x*(i+1);for(let m=0;m<i;m++){let S=m+p,C=S,b=S+i+1,A=S+i+2,E=S+1;a.push(C,b,E),a.push(b,A,E)}}this.setIndex(a),this.setAttribute("position",new oe(c,3)),this.setAttribute("normal",new oe(l,3)),this.setAttribute("uv",new oe(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var ws=class s extends Kt{constructor(t=1,e=32,i=16,n=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:n,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,h=[],u=new D,d=new D,f=[],g=[],x=[],p=[];for(let m=0;m<=i;m++){let S=[],C=m/i,b=o+C*a,A=t*Math.cos(b),E=Math.sqrt(t*t-A*A),_=0;m===0&&o===0?_=.5/e:m===i&&c===Math.PI&&(_=-.5/e);for(let M=0;M<=e;M++){let F=M/e,P=n+F*r;u.x=-E*Math.cos(P),u.y=A,u.z=E*Math.sin(P),g.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),p.push(F+_,1-C),S.push(l++)}h.push(S)}for(let m=0;m<i;m++)for(let S=0;S<e;S++){let C=h[m][S+1],b=h[m][S],A=h[m+1][S],E=h[m+1][S+1];(m!==0||o>0)&&f.push(C,b,E),(m!==i-1||c<Math.PI)&&f.push(b,A,E)}this.setIndex(f),this.setAttribute("position",new oe(g,3)),this.setAttribute("normal",new oe(x,3)),this.setAttribute("uv",new oe(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var mr=class extends Kt{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],i=new Set,n=new D,r=new D;if(t.index!==null){let o=t.attributes.position,a=t.index,c=t.groups;c.length===0&&(c=[{start:0,count:a.count,materialIndex:0}]);for(let l=0,h=c.length;l<h;++l){let u=c[l],d=u.start,f=u.count;for(let g=d,x=d+f;g<x;g+=3)for(let p=0;p<3;p++){let m=a.getX(g+p),S=a.getX(g+(p+1)%3);n.fromBufferAttribute(o,m),r.fromBufferAttribute(o,S),Tu(n,r,i)===!0&&(e.push(n.x,n.y,n.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,c=o.count/3;a<c;a++)for(let l=0;l<3;l++){let h=3*a+l,u=3*a+(l+1)%3;n.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),Tu(n,r,i)===!0&&(e.push(n.x,n.y,n.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new oe(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Tu(s,t,e){let i=`${s.x},${s.y},${s.z}-${t.x},${t.y},${t.z}`,n=`${t.x},${t.y},${t.z}-${s.x},${s.y},${s.z}`;return e.has(i)===!0||e.has(n)===!0?!1:(e.add(i),e.add(n),!0)}var gr=class extends Ti{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new At(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function Zn(s){let t={};for(let e in s){t[e]={};for(let i in s[e]){let n=s[e][i];if(Cu(n))n.isRenderTargetTexture?(It("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=n.clone();else if(Array.isArray(n))if(Cu(n[0])){let r=[];for(let o=0,a=n.length;o<a;o++)r[o]=n[o].clone();t[e][i]=r}else t[e][i]=n.slice();else t[e][i]=n}}return t}function We(s){let t={};for(let e=0;e<s.length;e++){let i=Zn(s[e]);for(let n in i)t[n]=i[n]}return t}function Cu(s){return s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)}function rm(s){let t=[];for(let e=0;e<s.length;e++)t.push(s[e].clone());return t}function Jl(s){let t=s.getRenderTarget();return t===null?s.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:$t.workingColorSpace}var bd={clone:Zn,merge:We},om=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,am=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Oi=class extends Ti{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=om,this.fragmentShader=am,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Zn(t.uniforms),this.uniformsGroups=rm(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let n in this.uniforms){let o=this.uniforms[n].value;o&&o.isTexture?e.uniforms[n]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[n]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[n]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[n]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[n]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[n]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[n]={type:"m4",value:o.toArray()}:e.uniforms[n]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let n in this.extensions)this.extensions[n]===!0&&(i[n]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let n=t.uniforms[i];switch(this.uniforms[i]={},n.type){case"t":this.uniforms[i].value=e[n.value]||null;break;case"c":this.uniforms[i].value=new At().setHex(n.value);break;case"v2":this.uniforms[i].value=new Rt().fromArray(n.value);break;case"v3":this.uniforms[i].value=new D().fromArray(n.value);break;case"v4":this.uniforms[i].value=new me().fromArray(n.value);break;case"m3":this.uniforms[i].value=new Ft().fromArray(n.value);break;case"m4":this.uniforms[i].value=new re().fromArray(n.value);break;default:this.uniforms[i].value=n.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Yo=class extends Oi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Gn=class extends Ti{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new At(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new At(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Za,this.normalScale=new Rt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ji,this.combine=ca,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},$o=class extends Ti{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ad,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Zo=class extends Ti{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function us(s,t){return!s||s.constructor===t?s:typeof t.BYTES_PER_ELEMENT=="number"?new t(s):Array.prototype.slice.call(s)}function Ao(s){return s!==void 0&&s.inTangents!==void 0&&s.outTangents!==void 0}var Sn=class{constructor(t,e,i,n){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=n!==void 0?n:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,n=e[i],r=e[i-1];i:{t:{let o;e:{n:if(!(t<n)){for(let a=i+2;;){if(n===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=n,n=e[++i],t<n)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(n=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break i}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(n=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,n)}return this.interpolate_(i,r,t,n)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,n=this.valueSize,r=t*n;for(let o=0;o!==n;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Jo=class extends Sn{constructor(t,e,i,n){super(t,e,i,n),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:pl,endingEnd:pl}}intervalChanged_(t,e,i){let n=this.parameterPositions,r=t-2,o=t+1,a=n[r],c=n[o];if(a===void 0)switch(this.getSettings_().endingStart){case ml:r=t,a=2*e-i;break;case gl:r=n.length-2,a=e+n[r]-n[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case ml:o=t,c=2*i-e;break;case gl:o=1,c=i+n[1]-n[0];break;default:o=t-1,c=e}let l=(i-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,n){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(i-e)/(n-e),x=g*g,p=x*g,m=-d*p+2*d*x-d*g,S=(1+d)*p+(-1.5-2*d)*x+(-.5+d)*g+1,C=(-1-f)*p+(1.5+f)*x+.5*g,b=f*p-f*x;for(let A=0;A!==a;++A)r[A]=m*o[h+A]+S*o[l+A]+C*o[c+A]+b*o[u+A];return r}},Ko=class extends Sn{constructor(t,e,i,n){super(t,e,i,n)}interpolate_(t,e,i,n){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(i-e)/(n-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*u+o[c+d]*h;return r}},jo=class extends Sn{constructor(t,e,i,n){super(t,e,i,n)}interpolate_(t){return this.copySampleValue_(t-1)}},Qo=class extends Sn{interpolate_(t,e,i,n){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(i-e)/(n-e),x=1-g;for(let p=0;p!==a;++p)r[p]=o[l+p]*x+o[c+p]*g;return r}let d=a*2,f=t-1;for(let g=0;g!==a;++g){let x=o[l+g],p=o[c+g],m=f*d+g*2,S=u[m],C=u[m+1],b=t*d+g*2,A=h[b],E=h[b+1],_=lm(i,e,S,A,n);r[g]=wd(_,x,C,E,p)}return r}};function wd(s,t,e,i,n){let r=1-s;return r*r*r*t+3*r*r*s*e+3*r*s*s*i+s*s*s*n}function cm(s,t,e,i,n){let r=1-s;return 3*r*r*(e-t)+6*r*s*(i-e)+3*s*s*(n-i)}function lm(s,t,e,i,n){let r=(s-t)/(n-t);for(let o=0;o<8;o++){let a=wd(r,t,e,i,n)-s;if(Math.abs(a)<1e-10)break;let c=cm(r,t,e,i,n);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var li=class{constructor(t,e,i,n){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=us(e,this.TimeBufferType),this.values=us(i,this.ValueBufferType),this.setInterpolation(n||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:us(t.times,Array),values:us(t.values,Array)};let n=t.getInterpolation();n!==t.DefaultInterpolation&&(i.interpolation=n),Ao(t.settings)&&(i.settings={inTangents:us(t.settings.inTangents,Array),outTangents:us(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new jo(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Ko(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Jo(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Qo(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case js:e=this.InterpolantFactoryMethodDiscrete;break;case zo:e=this.InterpolantFactoryMethodLinear;break;case Ro:e=this.InterpolantFactoryMethodSmooth;break;case fl:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return It("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return js;case this.InterpolantFactoryMethodLinear:return zo;case this.InterpolantFactoryMethodSmooth:return Ro;case this.InterpolantFactoryMethodBezier:return fl}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,n=e.length;i!==n;++i)e[i]+=t;Ao(this.settings)&&(Ru(this.settings.inTangents,t),Ru(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,n=e.length;i!==n;++i)e[i]*=t;Ao(this.settings)&&(Pu(this.settings.inTangents,t),Pu(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,n=i.length,r=0,o=n-1;for(;r!==n&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==n){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Lt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,n=this.values,r=i.length;r===0&&(Lt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){Lt("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){Lt("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(n!==void 0&&wp(n))for(let a=0,c=n.length;a!==c;++a){let l=n[a];if(isNaN(l)){Lt("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),n=this.getInterpolation()===Ro,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(n)c=!0;else{let u=a*i,d=u-i,f=u+i;for(let g=0;g!==i;++g){let x=e[u+g];if(x!==e[d+g]||x!==e[f+g]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,n=new i(this.name,t,e);return n.createInterpolant=this.createInterpolant,Ao(this.settings)&&(n.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),n}};function Ru(s,t){for(let e=0,i=s.length;e!==i;e+=2)s[e]+=t}function Pu(s,t){for(let e=0,i=s.length;e!==i;e+=2)s[e]*=t}li.prototype.ValueTypeName="";li.prototype.TimeBufferType=Float32Array;li.prototype.ValueBufferType=Float32Array;li.prototype.DefaultInterpolation=zo;var Mn=class extends li{constructor(t,e,i){super(t,e,i)}};Mn.prototype.ValueTypeName="bool";Mn.prototype.ValueBufferType=Array;Mn.prototype.DefaultInterpolation=js;Mn.prototype.InterpolantFactoryMethodLinear=void 0;Mn.prototype.InterpolantFactoryMethodSmooth=void 0;var ta=class extends li{constructor(t,e,i,n){super(t,e,i,n)}};ta.prototype.ValueTypeName="color";var ea=class extends li{constructor(t,e,i,n){super(t,e,i,n)}};ea.prototype.ValueTypeName="number";var ia=class extends Sn{constructor(t,e,i,n){super(t,e,i,n)}interpolate_(t,e,i,n){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(n-e),l=t*a;for(let h=l+a;l!==h;l+=4)Ne.slerpFlat(r,0,o,l-a,o,l,c);return r}},_r=class extends li{constructor(t,e,i,n){super(t,e,i,n)}InterpolantFactoryMethodLinear(t){return new ia(this.times,this.values,this.getValueSize(),t)}};_r.prototype.ValueTypeName="quaternion";_r.prototype.InterpolantFactoryMethodSmooth=void 0;var bn=class extends li{constructor(t,e,i){super(t,e,i)}};bn.prototype.ValueTypeName="string";bn.prototype.ValueBufferType=Array;bn.prototype.DefaultInterpolation=js;bn.prototype.InterpolantFactoryMethodLinear=void 0;bn.prototype.InterpolantFactoryMethodSmooth=void 0;var na=class extends li{constructor(t,e,i,n){super(t,e,i,n)}};na.prototype.ValueTypeName="vector";var sa=class{constructor(t,e,i){let n=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&n.onStart!==void 0&&n.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,n.onProgress!==void 0&&n.onProgress(h,o,a),o===a&&(r=!1,n.onLoad!==void 0&&n.onLoad())},this.itemError=function(h){n.onError!==void 0&&n.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=l.length;u<d;u+=2){let f=l[u],g=l[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ed=new sa,ra=class{constructor(t){this.manager=t!==void 0?t:Ed,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(n,r){i.load(t,n,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};ra.DEFAULT_MATERIAL_NAME="__DEFAULT";var xr=class extends Fe{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new At(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},yr=class extends xr{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Fe.DEFAULT_UP),this.updateMatrix(),this.groundColor=new At(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},dl=new re,Iu=new D,Du=new D,oa=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Rt(512,512),this.mapType=ei,this.map=null,this.mapPass=null,this.matrix=new re,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new _n,this._frameExtents=new Rt(1,1),this._viewportCount=1,this._viewports=[new me(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Iu.setFromMatrixPosition(t.matrixWorld),e.position.copy(Iu),Du.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Du),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,n){dl.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(dl,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=n?n.z/r.x:1,a=n?n.w/r.y:1,c=n?n.x/r.x:0,l=n?n.y/r.y:0;t.coordinateSystem===_s||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(dl)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},To=new D,Co=new Ne,Ni=new D,vr=class extends Fe{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new re,this.projectionMatrix=new re,this.projectionMatrixInverse=new re,this.coordinateSystem=_i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(To,Co,Ni),Ni.x===1&&Ni.y===1&&Ni.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(To,Co,Ni.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(To,Co,Ni),Ni.x===1&&Ni.y===1&&Ni.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(To,Co,Ni.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},gn=new D,Lu=new Rt,Nu=new Rt,$e=class extends vr{constructor(t=50,e=1,i=.1,n=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=n,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ys*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ps*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ys*2*Math.atan(Math.tan(ps*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){gn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(gn.x,gn.y).multiplyScalar(-t/gn.z),gn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(gn.x,gn.y).multiplyScalar(-t/gn.z)}getViewSize(t,e){return this.getViewBounds(t,Lu,Nu),e.subVectors(Nu,Lu)}setViewOffset(t,e,i,n,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=n,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ps*.5*this.fov)/this.zoom,i=2*e,n=this.aspect*i,r=-.5*n,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*n/c,e-=o.offsetY*i/l,n*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+n,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Sr=class extends vr{constructor(t=-1,e=1,i=1,n=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=n,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,n,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=n,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,n=(this.top+this.bottom)/2,r=i-t,o=i+t,a=n+e,c=n-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},xl=class extends oa{constructor(){super(new Sr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Mr=class extends xr{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Fe.DEFAULT_UP),this.updateMatrix(),this.target=new Fe,this.shadow=new xl}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var ds=-90,fs=1,Es=class extends Fe{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let n=new $e(ds,fs,t,e);n.layers=this.layers,this.add(n);let r=new $e(ds,fs,t,e);r.layers=this.layers,this.add(r);let o=new $e(ds,fs,t,e);o.layers=this.layers,this.add(o);let a=new $e(ds,fs,t,e);a.layers=this.layers,this.add(a);let c=new $e(ds,fs,t,e);c.layers=this.layers,this.add(c);let l=new $e(ds,fs,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,n,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===_i)i.up.set(0,1,0),i.lookAt(1,0,0),n.up.set(0,1,0),n.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===_s)i.up.set(0,-1,0),i.lookAt(-1,0,0),n.up.set(0,-1,0),n.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:n}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,n),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,n),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,n),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,n),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,n),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,n),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},aa=class extends $e{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Kl="\\[\\]\\.:\\/",hm=new RegExp("["+Kl+"]","g"),jl="[^"+Kl+"]",um="[^"+Kl.replace("\\.","")+"]",dm=/((?:WC+[\/:])*)/.source.replace("WC",jl),fm=/(WCOD+)?/.source.replace("WCOD",um),pm=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",jl),mm=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",jl),gm=new RegExp("^"+dm+fm+pm+mm+"$"),_m=["material","materials","bones","map"],yl=class{constructor(t,e,i){let n=i||de.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,n)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,n=this._bindings[i];n!==void 0&&n.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let n=this._targetGroup.nCachedObjects_,r=i.length;n!==r;++n)i[n].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},de=class s{constructor(t,e,i){this.path=e,this.parsedPath=i||s.parseTrackName(e),this.node=s.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new s.Composite(t,e,i):new s(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(hm,"")}static parseTrackName(t){let e=gm.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},n=i.nodeName&&i.nodeName.lastIndexOf(".");if(n!==void 0&&n!==-1){let r=i.nodeName.substring(n+1);_m.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,n),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},n=i(t.children);if(n)return n}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let n=0,r=i.length;n!==r;++n)t[e++]=i[n]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let n=0,r=i.length;n!==r;++n)i[n]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let n=0,r=i.length;n!==r;++n)i[n]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let n=0,r=i.length;n!==r;++n)i[n]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,n=e.propertyName,r=e.propertyIndex;if(t||(t=s.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){It("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){Lt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Lt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Lt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Lt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Lt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Lt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){Lt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[n];if(o===void 0){let l=e.nodeName;Lt("PropertyBinding: Trying to update property for track: "+l+"."+n+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(n==="morphTargetInfluences"){if(!t.geometry){Lt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Lt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=n;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};de.Composite=yl;de.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};de.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};de.prototype.GetterByBindingType=[de.prototype._getValue_direct,de.prototype._getValue_array,de.prototype._getValue_arrayElement,de.prototype._getValue_toArray];de.prototype.SetterByBindingTypeAndVersioning=[[de.prototype._setValue_direct,de.prototype._setValue_direct_setNeedsUpdate,de.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[de.prototype._setValue_array,de.prototype._setValue_array_setNeedsUpdate,de.prototype._setValue_array_setMatrixWorldNeedsUpdate],[de.prototype._setValue_arrayElement,de.prototype._setValue_arrayElement_setNeedsUpdate,de.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[de.prototype._setValue_fromArray,de.prototype._setValue_fromArray_setNeedsUpdate,de.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var kS=new Float32Array(1);var Fu=new re,Vn=class{constructor(t,e,i=0,n=1/0){this.ray=new Qi(t,e),this.near=i,this.far=n,this.camera=null,this.layers=new Ss,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Lt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Fu.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Fu),this}intersectObject(t,e=!0,i=[]){return vl(t,this,i,e),i.sort(Bu),i}intersectObjects(t,e=!0,i=[]){for(let n=0,r=t.length;n<r;n++)vl(t[n],this,i,e);return i.sort(Bu),i}};function Bu(s,t){return s.distance-t.distance}function vl(s,t,e,i){let n=!0;if(s.layers.test(t.layers)&&s.raycast(t,e)===!1&&(n=!1),n===!0&&i===!0){let r=s.children;for(let o=0,a=r.length;o<a;o++)vl(r[o],t,e,!0)}}var As=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Wt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Wt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Sl=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,n){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,n)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,n){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=n,this}};var br=class extends Ai{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Ql(s,t,e,i){let n=xm(i);switch(e){case zl:return s*t;case ma:return s*t/n.components*n.byteLength;case ga:return s*t/n.components*n.byteLength;case Tn:return s*t*2/n.components*n.byteLength;case _a:return s*t*2/n.components*n.byteLength;case Gl:return s*t*3/n.components*n.byteLength;case Ii:return s*t*4/n.components*n.byteLength;case xa:return s*t*4/n.components*n.byteLength;case Er:case Ar:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*8;case Tr:case Cr:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case va:case Ma:return Math.max(s,16)*Math.max(t,8)/4;case ya:case Sa:return Math.max(s,8)*Math.max(t,8)/2;case ba:case wa:case Aa:case Ta:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*8;case Ea:case Rr:case Ca:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case Ra:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case Pa:return Math.floor((s+4)/5)*Math.floor((t+3)/4)*16;case Ia:return Math.floor((s+4)/5)*Math.floor((t+4)/5)*16;case Da:return Math.floor((s+5)/6)*Math.floor((t+4)/5)*16;case La:return Math.floor((s+5)/6)*Math.floor((t+5)/6)*16;case Na:return Math.floor((s+7)/8)*Math.floor((t+4)/5)*16;case Fa:return Math.floor((s+7)/8)*Math.floor((t+5)/6)*16;case Ba:return Math.floor((s+7)/8)*Math.floor((t+7)/8)*16;case Oa:return Math.floor((s+9)/10)*Math.floor((t+4)/5)*16;case Ua:return Math.floor((s+9)/10)*Math.floor((t+5)/6)*16;case ka:return Math.floor((s+9)/10)*Math.floor((t+7)/8)*16;case za:return Math.floor((s+9)/10)*Math.floor((t+9)/10)*16;case Ga:return Math.floor((s+11)/12)*Math.floor((t+9)/10)*16;case Va:return Math.floor((s+11)/12)*Math.floor((t+11)/12)*16;case Ha:case Wa:case Xa:return Math.ceil(s/4)*Math.ceil(t/4)*16;case qa:case Ya:return Math.ceil(s/4)*Math.ceil(t/4)*8;case Pr:case $a:return Math.ceil(s/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function xm(s){switch(s){case ei:case Bl:return{byteLength:1,components:1};case Ps:case Ol:case Pi:return{byteLength:2,components:1};case fa:case pa:return{byteLength:2,components:4};case Ri:case da:case yi:return{byteLength:4,components:1};case Ul:case kl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${s}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?It("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Yd(){let s=null,t=!1,e=null,i=null;function n(r,o){i=s.requestAnimationFrame(n),e(r,o)}return{start:function(){t!==!0&&e!==null&&s!==null&&(i=s.requestAnimationFrame(n),t=!0)},stop:function(){s!==null&&s.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){s=r}}}function vm(s){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,u=l.byteLength,d=s.createBuffer();s.bindBuffer(c,d),s.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=s.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=s.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=s.HALF_FLOAT:f=s.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=s.SHORT;else if(l instanceof Uint32Array)f=s.UNSIGNED_INT;else if(l instanceof Int32Array)f=s.INT;else if(l instanceof Int8Array)f=s.BYTE;else if(l instanceof Uint8Array)f=s.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=s.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,c,l){let h=c.array,u=c.updateRanges;if(s.bindBuffer(l,a),u.length===0)s.bufferSubData(l,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],x=u[f];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let x=u[f];s.bufferSubData(l,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}c.clearUpdateRanges()}c.onUploadCallback()}function n(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(s.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:n,remove:r,update:o}}var Sm=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Mm=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,bm=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,wm=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Em=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Am=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Tm=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Cm=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Rm=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Pm=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Im=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Dm=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Lm=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Nm=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Fm=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Bm=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Om=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Um=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,km=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,zm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Gm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Vm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Hm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Wm=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Xm=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,qm=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ym=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,$m=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Zm=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Jm="gl_FragColor = linearToOutputTexel( gl_FragColor );",Km=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,jm=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Qm=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,tg=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,eg=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ig=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,ng=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,sg=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,rg=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,og=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ag=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,cg=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,lg=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,hg=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ug=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,dg=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,fg=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,pg=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,mg=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gg=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,_g=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,xg=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,yg=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,vg=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Sg=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Mg=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,bg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,wg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Eg=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ag=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Tg=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Cg=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Rg=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Pg=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ig=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Dg=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Lg=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ng=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Fg=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Bg=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Og=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ug=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,kg=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,zg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Vg=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Hg=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Wg=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Xg=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qg=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Yg=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,$g=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Zg=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Jg=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Kg=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,jg=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Qg=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,t0=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,e0=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,i0=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,n0=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,s0=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,r0=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,o0=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,a0=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,c0=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,l0=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,h0=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,u0=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,d0=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,f0=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,p0=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,m0=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,g0=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,_0=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,x0=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,y0=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,v0=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,S0=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,M0=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,b0=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,w0=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,E0=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,A0=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,T0=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,C0=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,R0=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,P0=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,I0=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,D0=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,L0=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,N0=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,F0=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,B0=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,O0=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,U0=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,k0=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,z0=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,G0=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,V0=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,H0=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,W0=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,X0=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,q0=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Y0=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$0=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Z0=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,J0=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,K0=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,j0=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Q0=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Gt={alphahash_fragment:Sm,alphahash_pars_fragment:Mm,alphamap_fragment:bm,alphamap_pars_fragment:wm,alphatest_fragment:Em,alphatest_pars_fragment:Am,aomap_fragment:Tm,aomap_pars_fragment:Cm,batching_pars_vertex:Rm,batching_vertex:Pm,begin_vertex:Im,beginnormal_vertex:Dm,bsdfs:Lm,iridescence_fragment:Nm,bumpmap_pars_fragment:Fm,clipping_planes_fragment:Bm,clipping_planes_pars_fragment:Om,clipping_planes_pars_vertex:Um,clipping_planes_vertex:km,color_fragment:zm,color_pars_fragment:Gm,color_pars_vertex:Vm,color_vertex:Hm,common:Wm,defaultnormal_vertex:Xm,displacementmap_pars_vertex:qm,displacementmap_vertex:Ym,emissivemap_fragment:$m,emissivemap_pars_fragment:Zm,colorspace_fragment:Jm,colorspace_pars_fragment:Km,envmap_fragment:jm,envmap_common_pars_fragment:Qm,envmap_pars_fragment:tg,envmap_pars_vertex:eg,envmap_physical_pars_fragment:dg,envmap_vertex:ig,fog_vertex:ng,fog_pars_vertex:sg,fog_fragment:rg,fog_pars_fragment:og,gradientmap_pars_fragment:ag,lightmap_pars_fragment:cg,lights_lambert_fragment:lg,lights_lambert_pars_fragment:hg,lights_pars_begin:ug,lights_toon_fragment:fg,lights_toon_pars_fragment:pg,lights_phong_fragment:mg,lights_phong_pars_fragment:gg,lights_physical_fragment:_g,lights_physical_pars_fragment:xg,lights_fragment_begin:yg,lights_fragment_maps:vg,lights_fragment_end:Sg,lightprobes_pars_fragment:Mg,logdepthbuf_fragment:bg,logdepthbuf_pars_fragment:wg,logdepthbuf_pars_vertex:Eg,logdepthbuf_vertex:Ag,map_fragment:Tg,map_pars_fragment:Cg,map_particle_fragment:Rg,map_particle_pars_fragment:Pg,metalnessmap_fragment:Ig,metalnessmap_pars_fragment:Dg,morphinstance_vertex:Lg,morphcolor_vertex:Ng,morphnormal_vertex:Fg,morphtarget_pars_vertex:Bg,morphtarget_vertex:Og,normal_fragment_begin:Ug,normal_fragment_maps:kg,normal_pars_fragment:zg,normal_pars_vertex:Gg,normal_vertex:Vg,normalmap_pars_fragment:Hg,clearcoat_normal_fragment_begin:Wg,clearcoat_normal_fragment_maps:Xg,clearcoat_pars_fragment:qg,iridescence_pars_fragment:Yg,opaque_fragment:$g,packing:Zg,premultiplied_alpha_fragment:Jg,project_vertex:Kg,dithering_fragment:jg,dithering_pars_fragment:Qg,roughnessmap_fragment:t0,roughnessmap_pars_fragment:e0,shadowmap_pars_fragment:i0,shadowmap_pars_vertex:n0,shadowmap_vertex:s0,shadowmask_pars_fragment:r0,skinbase_vertex:o0,skinning_pars_vertex:a0,skinning_vertex:c0,skinnormal_vertex:l0,specularmap_fragment:h0,specularmap_pars_fragment:u0,tonemapping_fragment:d0,tonemapping_pars_fragment:f0,transmission_fragment:p0,transmission_pars_fragment:m0,uv_pars_fragment:g0,uv_pars_vertex:_0,uv_vertex:x0,worldpos_vertex:y0,background_vert:v0,background_frag:S0,backgroundCube_vert:M0,backgroundCube_frag:b0,cube_vert:w0,cube_frag:E0,depth_vert:A0,depth_frag:T0,distance_vert:C0,distance_frag:R0,equirect_vert:P0,equirect_frag:I0,linedashed_vert:D0,linedashed_frag:L0,meshbasic_vert:N0,meshbasic_frag:F0,meshlambert_vert:B0,meshlambert_frag:O0,meshmatcap_vert:U0,meshmatcap_frag:k0,meshnormal_vert:z0,meshnormal_frag:G0,meshphong_vert:V0,meshphong_frag:H0,meshphysical_vert:W0,meshphysical_frag:X0,meshtoon_vert:q0,meshtoon_frag:Y0,points_vert:$0,points_frag:Z0,shadow_vert:J0,shadow_frag:K0,sprite_vert:j0,sprite_frag:Q0},gt={common:{diffuse:{value:new At(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ft}},envmap:{envMap:{value:null},envMapRotation:{value:new Ft},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ft}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ft}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ft},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ft},normalScale:{value:new Rt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ft},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ft}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ft}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ft}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new At(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new At(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0},uvTransform:{value:new Ft}},sprite:{diffuse:{value:new At(16777215)},opacity:{value:1},center:{value:new Rt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}}},zi={basic:{uniforms:We([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.fog]),vertexShader:Gt.meshbasic_vert,fragmentShader:Gt.meshbasic_frag},lambert:{uniforms:We([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,gt.lights,{emissive:{value:new At(0)},envMapIntensity:{value:1}}]),vertexShader:Gt.meshlambert_vert,fragmentShader:Gt.meshlambert_frag},phong:{uniforms:We([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,gt.lights,{emissive:{value:new At(0)},specular:{value:new At(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Gt.meshphong_vert,fragmentShader:Gt.meshphong_frag},standard:{uniforms:We([gt.common,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.roughnessmap,gt.metalnessmap,gt.fog,gt.lights,{emissive:{value:new At(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Gt.meshphysical_vert,fragmentShader:Gt.meshphysical_frag},toon:{uniforms:We([gt.common,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.gradientmap,gt.fog,gt.lights,{emissive:{value:new At(0)}}]),vertexShader:Gt.meshtoon_vert,fragmentShader:Gt.meshtoon_frag},matcap:{uniforms:We([gt.common,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,{matcap:{value:null}}]),vertexShader:Gt.meshmatcap_vert,fragmentShader:Gt.meshmatcap_frag},points:{uniforms:We([gt.points,gt.fog]),vertexShader:Gt.points_vert,fragmentShader:Gt.points_frag},dashed:{uniforms:We([gt.common,gt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Gt.linedashed_vert,fragmentShader:Gt.linedashed_frag},depth:{uniforms:We([gt.common,gt.displacementmap]),vertexShader:Gt.depth_vert,fragmentShader:Gt.depth_frag},normal:{uniforms:We([gt.common,gt.bumpmap,gt.normalmap,gt.displacementmap,{opacity:{value:1}}]),vertexShader:Gt.meshnormal_vert,fragmentShader:Gt.meshnormal_frag},sprite:{uniforms:We([gt.sprite,gt.fog]),vertexShader:Gt.sprite_vert,fragmentShader:Gt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ft},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Gt.background_vert,fragmentShader:Gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ft}},vertexShader:Gt.backgroundCube_vert,fragmentShader:Gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Gt.cube_vert,fragmentShader:Gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Gt.equirect_vert,fragmentShader:Gt.equirect_frag},distance:{uniforms:We([gt.common,gt.displacementmap,{referencePosition:{value:new D},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Gt.distance_vert,fragmentShader:Gt.distance_frag},shadow:{uniforms:We([gt.lights,gt.fog,{color:{value:new At(0)},opacity:{value:1}}]),vertexShader:Gt.shadow_vert,fragmentShader:Gt.shadow_frag}};zi.physical={uniforms:We([zi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ft},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ft},clearcoatNormalScale:{value:new Rt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ft},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ft},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ft},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ft},sheen:{value:0},sheenColor:{value:new At(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ft},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ft},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ft},transmissionSamplerSize:{value:new Rt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ft},attenuationDistance:{value:0},attenuationColor:{value:new At(0)},specularColor:{value:new At(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ft},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ft},anisotropyVector:{value:new Rt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ft}}]),vertexShader:Gt.meshphysical_vert,fragmentShader:Gt.meshphysical_frag};var Ja={r:0,b:0,g:0},t_=new re,$d=new Ft;$d.set(-1,0,0,0,1,0,0,0,1);function e_(s,t,e,i,n,r){let o=new At(0),a=n===!0?0:1,c,l,h=null,u=0,d=null;function f(S){let C=S.isScene===!0?S.background:null;if(C&&C.isTexture){let b=S.backgroundBlurriness>0;C=t.get(C,b)}return C}function g(S){let C=!1,b=f(S);b===null?p(o,a):b&&b.isColor&&(p(b,1),C=!0);let A=s.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(s.autoClear||C)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),s.clear(s.autoClearColor,s.autoClearDepth,s.autoClearStencil))}function x(S,C){let b=f(C);b&&b.isCubeTexture?(l===void 0&&(l=new Me(new yn(1,1,1),new Oi({name:"BackgroundCubeMaterial",uniforms:Zn(zi.backgroundCube.uniforms),vertexShader:zi.backgroundCube.vertexShader,fragmentShader:zi.backgroundCube.fragmentShader,side:Ke,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(A,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=b,l.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(t_.makeRotationFromEuler(C.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply($d),l.material.toneMapped=$t.getTransfer(b.colorSpace)!==se,(h!==b||u!==b.version||d!==s.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=s.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new Me(new fr(2,2),new Oi({name:"BackgroundMaterial",uniforms:Zn(zi.background.uniforms),vertexShader:zi.background.vertexShader,fragmentShader:zi.background.fragmentShader,side:An,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.toneMapped=$t.getTransfer(b.colorSpace)!==se,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==s.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=s.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function p(S,C){S.getRGB(Ja,Jl(s)),e.buffers.color.setClear(Ja.r,Ja.g,Ja.b,C,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(S,C=1){o.set(S),a=C,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(S){a=S,p(o,a)},render:g,addToRenderList:x,dispose:m}}function i_(s,t){let e=s.getParameter(s.MAX_VERTEX_ATTRIBS),i={},n=d(null),r=n,o=!1;function a(L,B,z,T,V){let W=!1,G=u(L,T,z,B);r!==G&&(r=G,l(r.object)),W=f(L,T,z,V),W&&g(L,T,z,V),V!==null&&t.update(V,s.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,b(L,B,z,T),V!==null&&s.bindBuffer(s.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function c(){return s.createVertexArray()}function l(L){return s.bindVertexArray(L)}function h(L){return s.deleteVertexArray(L)}function u(L,B,z,T){let V=T.wireframe===!0,W=i[B.id];W===void 0&&(W={},i[B.id]=W);let G=L.isInstancedMesh===!0?L.id:0,Q=W[G];Q===void 0&&(Q={},W[G]=Q);let X=Q[z.id];X===void 0&&(X={},Q[z.id]=X);let J=X[V];return J===void 0&&(J=d(c()),X[V]=J),J}function d(L){let B=[],z=[],T=[];for(let V=0;V<e;V++)B[V]=0,z[V]=0,T[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:z,attributeDivisors:T,object:L,attributes:{},index:null}}function f(L,B,z,T){let V=r.attributes,W=B.attributes,G=0,Q=z.getAttributes();for(let X in Q)if(Q[X].location>=0){let tt=V[X],yt=W[X];if(yt===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(yt=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(yt=L.instanceColor)),tt===void 0||tt.attribute!==yt||yt&&tt.data!==yt.data)return!0;G++}return r.attributesNum!==G||r.index!==T}function g(L,B,z,T){let V={},W=B.attributes,G=0,Q=z.getAttributes();for(let X in Q)if(Q[X].location>=0){let tt=W[X];tt===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(tt=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(tt=L.instanceColor));let yt={};yt.attribute=tt,tt&&tt.data&&(yt.data=tt.data),V[X]=yt,G++}r.attributes=V,r.attributesNum=G,r.index=T}function x(){let L=r.newAttributes;for(let B=0,z=L.length;B<z;B++)L[B]=0}function p(L){m(L,0)}function m(L,B){let z=r.newAttributes,T=r.enabledAttributes,V=r.attributeDivisors;z[L]=1,T[L]===0&&(s.enableVertexAttribArray(L),T[L]=1),V[L]!==B&&(s.vertexAttribDivisor(L,B),V[L]=B)}function S(){let L=r.newAttributes,B=r.enabledAttributes;for(let z=0,T=B.length;z<T;z++)B[z]!==L[z]&&(s.disableVertexAttribArray(z),B[z]=0)}function C(L,B,z,T,V,W,G){G===!0?s.vertexAttribIPointer(L,B,z,V,W):s.vertexAttribPointer(L,B,z,T,V,W)}function b(L,B,z,T){x();let V=T.attributes,W=z.getAttributes(),G=B.defaultAttributeValues;for(let Q in W){let X=W[Q];if(X.location>=0){let J=V[Q];if(J===void 0&&(Q==="instanceMatrix"&&L.instanceMatrix&&(J=L.instanceMatrix),Q==="instanceColor"&&L.instanceColor&&(J=L.instanceColor)),J!==void 0){let tt=J.normalized,yt=J.itemSize,Tt=t.get(J);if(Tt===void 0)continue;let Y=Tt.buffer,dt=Tt.type,et=Tt.bytesPerElement,xt=dt===s.INT||dt===s.UNSIGNED_INT||J.gpuType===da;if(J.isInterleavedBufferAttribute){let ft=J.data,Nt=ft.isInterleavedBuffer===!0?ft.stride:ft.itemSize,ge=J.offset;if(ft.isInstancedInterleavedBuffer||ft.isInstancedBufferAttribute){for(let Pt=0;Pt<X.locationSize;Pt++)m(X.location+Pt,ft.meshPerAttribute);L.isInstancedMesh!==!0&&T._maxInstanceCount===void 0&&(T._maxInstanceCount=ft.meshPerAttribute*ft.count)}else for(let Pt=0;Pt<X.locationSize;Pt++)p(X.location+Pt);s.bindBuffer(s.ARRAY_BUFFER,Y);for(let Pt=0;Pt<X.locationSize;Pt++)C(X.location+Pt,yt/X.locationSize,dt,tt,Nt*et,(ge+yt/X.locationSize*Pt)*et,xt)}else{if(J.isInstancedBufferAttribute){for(let ft=0;ft<X.locationSize;ft++)m(X.location+ft,J.meshPerAttribute);L.isInstancedMesh!==!0&&T._maxInstanceCount===void 0&&(T._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let ft=0;ft<X.locationSize;ft++)p(X.location+ft);s.bindBuffer(s.ARRAY_BUFFER,Y);for(let ft=0;ft<X.locationSize;ft++)C(X.location+ft,yt/X.locationSize,dt,tt,yt*et,yt/X.locationSize*ft*et,xt)}}else if(G!==void 0){let tt=G[Q];if(tt!==void 0)switch(tt.length){case 2:s.vertexAttrib2fv(X.location,tt);break;case 3:s.vertexAttrib3fv(X.location,tt);break;case 4:s.vertexAttrib4fv(X.location,tt);break;default:s.vertexAttrib1fv(X.location,tt)}}}}S()}function A(){F();for(let L in i){let B=i[L];for(let z in B){let T=B[z];for(let V in T){let W=T[V];for(let G in W)h(W[G].object),delete W[G];delete T[V]}}delete i[L]}}function E(L){if(i[L.id]===void 0)return;let B=i[L.id];for(let z in B){let T=B[z];for(let V in T){let W=T[V];for(let G in W)h(W[G].object),delete W[G];delete T[V]}}delete i[L.id]}function _(L){for(let B in i){let z=i[B];for(let T in z){let V=z[T];if(V[L.id]===void 0)continue;let W=V[L.id];for(let G in W)h(W[G].object),delete W[G];delete V[L.id]}}}function M(L){for(let B in i){let z=i[B],T=L.isInstancedMesh===!0?L.id:0,V=z[T];if(V!==void 0){for(let W in V){let G=V[W];for(let Q in G)h(G[Q].object),delete G[Q];delete V[W]}delete z[T],Object.keys(z).length===0&&delete i[B]}}}function F(){P(),o=!0,r!==n&&(r=n,l(r.object))}function P(){n.geometry=null,n.program=null,n.wireframe=!1}return{setup:a,reset:F,resetDefaultState:P,dispose:A,releaseStatesOfGeometry:E,releaseStatesOfObject:M,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:p,disableUnusedAttributes:S}}function n_(s,t,e){let i;function n(c){i=c}function r(c,l){s.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,h){h!==0&&(s.drawArraysInstanced(i,c,l,h),e.update(l,i,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let d=0;for(let f=0;f<h;f++)d+=l[f];e.update(d,i,1)}this.setMode=n,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function s_(s,t,e,i){let n;function r(){if(n!==void 0)return n;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");n=s.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else n=0;return n}function o(_){return!(_!==Ii&&i.convert(_)!==s.getParameter(s.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let M=_===Pi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ei&&_!==yi&&!M&&i.convert(_)!==s.getParameter(s.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(s.getShaderPrecisionFormat(s.VERTEX_SHADER,s.HIGH_FLOAT).precision>0&&s.getShaderPrecisionFormat(s.FRAGMENT_SHADER,s.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&s.getShaderPrecisionFormat(s.VERTEX_SHADER,s.MEDIUM_FLOAT).precision>0&&s.getShaderPrecisionFormat(s.FRAGMENT_SHADER,s.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(It("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&It("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&It("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=s.getParameter(s.MAX_TEXTURE_IMAGE_UNITS),g=s.getParameter(s.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=s.getParameter(s.MAX_TEXTURE_SIZE),p=s.getParameter(s.MAX_CUBE_MAP_TEXTURE_SIZE),m=s.getParameter(s.MAX_VERTEX_ATTRIBS),S=s.getParameter(s.MAX_VERTEX_UNIFORM_VECTORS),C=s.getParameter(s.MAX_VARYING_VECTORS),b=s.getParameter(s.MAX_FRAGMENT_UNIFORM_VECTORS),A=s.getParameter(s.MAX_SAMPLES),E=s.getParameter(s.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:S,maxVaryings:C,maxFragmentUniforms:b,maxSamples:A,samples:E}}function r_(s){let t=this,e=null,i=0,n=!1,r=!1,o=new Ye,a=new Ft,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||n;return n=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,x=u.clipIntersection,p=u.clipShadows,m=s.get(u);if(!n||g===null||g.length===0||r&&!p)r?h(null):l();else{let S=r?0:i,C=S*4,b=m.clippingState||null;c.value=b,b=h(g,d,C,f);for(let A=0;A!==C;++A)b[A]=e[A];m.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=S}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,f,g){let x=u!==null?u.length:0,p=null;if(x!==0){if(p=c.value,g!==!0||p===null){let m=f+x*4,S=d.matrixWorldInverse;a.getNormalMatrix(S),(p===null||p.length<m)&&(p=new Float32Array(m));for(let C=0,b=f;C!==x;++C,b+=4)o.copy(u[C]).applyMatrix4(S,a),o.normal.toArray(p,b),p[b+3]=o.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,p}}var Lr=class extends ai{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},n=[i,i,i,i,i,i];this.texture=new ar(n),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},n=new yn(5,5,5),r=new Oi({name:"CubemapFromEquirect",uniforms:Zn(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Ke,blending:Wn});r.uniforms.tEquirect.value=e;let o=new Me(n,r),a=e.minFilter;return e.minFilter===en&&(e.minFilter=Ze),new Es(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,n=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,n);t.setRenderTarget(r)}},Ad=256,o_=3,a_=20,Zd=256,Jd=16,c_=3,l_=new D,h_=new At,ja=class s{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Es(1,10,null),this._boxMesh=new Me(new yn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,n=100,r={}){let{size:o=256,position:a=l_}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,g=c.autoClearStencil,x=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,x===null&&(t.background=c.getClearColor(h_));let p=new Es(i,n,h);return p.position.copy(a),p.update(c,t),c.autoClear=u,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=g,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Rd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Cd(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Ad,$l(t))}_fromTexture(t,e){t.mapping===qn||t.mapping===Rs?this._setSize(t.image.length===0?Ad:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Td(t,!1,!1),i=Math.log2(t)-o_;for(let n=0;n<=i;n++)e.texture.mipmaps.push({width:t>>n,height:t>>n});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Td(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let n=this._boxMesh,r=this._cubeCamera;n.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,n),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===qn||t.mapping===Rs?(this._cubemapMaterial===null&&(this._cubemapMaterial=Rd()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Cd()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=u_(),this._integrationMaterial=d_());let e=this._cubeSize,i=t.texture.mipmaps.length-1,n=this._ggxMaterial.uniforms;n.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Jd);for(let o=0;o<=i;o++){let a=s.lodToRoughness(o,i);if(o>i-c_)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(Zd*Math.pow(a,4)))+.5:0;n.roughness.value=a,n.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=f_());let i=this._blurMaterial,n=i.uniforms,r=this._sourceTarget;n.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,n.envMap.value=r.texture,this._renderCube(t,0,i),n.envMap.value=t.texture,this._renderCube(r,0,i)}};function Td(s,t,e){return new Lr(s,{minFilter:en,generateMipmaps:t,type:Pi,colorSpace:Un,depthBuffer:e})}function Nr(s,t,e){return new Oi({name:s,uniforms:t,vertexShader:Gt.cube_vert,fragmentShader:e,side:Ke,blending:Wn,depthTest:!1,depthWrite:!1})}function u_(){return Nr("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Zd}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function d_(){return Nr("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Jd}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function f_(){return Nr("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${a_}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Cd(){return Nr("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Rd(){return Nr("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function p_(s){let t=new WeakMap,e=new WeakMap,i=null;function n(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===la||f===ha)if(t.has(d)){let g=t.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let x=new Lr(g.height);return x.fromEquirectangularTexture(s,d),t.set(d,x),d.addEventListener("dispose",l),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===la||f===ha,x=f===qn||f===Rs;if(g||x){let p=e.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new ja(s)),p=g?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let S=d.image;return g&&S&&S.height>0||x&&S&&c(S)?(i===null&&(i=new ja(s)),p=g?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===la?d.mapping=qn:f===ha&&(d.mapping=Rs),d}function c(d){let f=0,g=6;for(let x=0;x<g;x++)d[x]!==void 0&&f++;return f===g}function l(d){let f=d.target;f.removeEventListener("dispose",l);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:n,dispose:u}}function m_(s){let t={};function e(i){if(t[i]!==void 0)return t[i];let n=s.getExtension(i);return t[i]=n,n}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let n=e(i);return n===null&&Js("WebGLRenderer: "+i+" extension not supported."),n}}}function g_(s,t,e,i){let n={},r=new WeakMap,o=new FinalizationRegistry(g=>delete n[g]);function a(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete n[g.id],o.unregister(g);let x=r.get(g);x&&(t.remove(x),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,x){return n[x.id]!==void 0||(x.addEventListener("dispose",a),n[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(g){let x=g.attributes;for(let p in x)t.update(x[p],s.ARRAY_BUFFER)}function u(g){let x=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let S=x!==null?x.array.length:p.array.length/3-1,C=p.count>=65535?sr:nr,b=new C(Math.ceil(S/3)*6,1),A=b.array;if(x!==null){let _=x.array;m=x.version;for(let M=0,F=0;M<S;M+=3){let P=_[M+0],L=_[M+1],B=_[M+2];A[F++]=P,A[F++]=L,A[F++]=L,A[F++]=B,A[F++]=B,A[F++]=P}}else{m=p.version;for(let _=0,M=0;_<S;_+=3){let F=_+0,P=_+1,L=_+2;A[M++]=F,A[M++]=P,A[M++]=P,A[M++]=L,A[M++]=L,A[M++]=F}}b.version=m;let E=r.get(g);E&&t.remove(E),r.set(g,b)}function d(g){let x=r.get(g);if(x){let p=g.index;p!==null&&x.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in n){let x=n[g].deref();x!==void 0&&c(x)}}return{get:l,update:h,getWireframeAttribute:d,dispose:f}}function __(s,t,e){let i;function n(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function c(u,d){s.drawElements(i,d,r,u*o),e.update(d,i,1)}function l(u,d,f){f!==0&&(s.drawElementsInstanced(i,d,r,u*o,f),e.update(d,i,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let x=0;for(let p=0;p<f;p++)x+=d[p];e.update(x,i,1)}this.setMode=n,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function x_(s){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case s.TRIANGLES:e.triangles+=a*(r/3);break;case s.LINES:e.lines+=a*(r/2);break;case s.LINE_STRIP:e.lines+=a*(r-1);break;case s.LINE_LOOP:e.lines+=a*r;break;case s.POINTS:e.points+=a*r;break;default:Lt("WebGLInfo: Unknown draw mode:",o);break}}function n(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:n,update:i}}function y_(s,t,e){let i=new WeakMap,n=new me;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let F=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",F)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],S=a.morphAttributes.color||[],C=0;f===!0&&(C=1),g===!0&&(C=2),x===!0&&(C=3);let b=a.attributes.position.count*C,A=1;b>t.maxTextureSize&&(A=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let E=new Float32Array(b*A*4*u),_=new er(E,b,A,u);_.type=yi,_.needsUpdate=!0;let M=C*4;for(let P=0;P<u;P++){let L=p[P],B=m[P],z=S[P],T=b*A*4*P;for(let V=0;V<L.count;V++){let W=V*M;f===!0&&(n.fromBufferAttribute(L,V),E[T+W+0]=n.x,E[T+W+1]=n.y,E[T+W+2]=n.z,E[T+W+3]=0),g===!0&&(n.fromBufferAttribute(B,V),E[T+W+4]=n.x,E[T+W+5]=n.y,E[T+W+6]=n.z,E[T+W+7]=0),x===!0&&(n.fromBufferAttribute(z,V),E[T+W+8]=n.x,E[T+W+9]=n.y,E[T+W+10]=n.z,E[T+W+11]=z.itemSize===4?n.w:1)}}d={count:u,texture:_,size:new Rt(b,A)},i.set(a,d),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(s,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<l.length;x++)f+=l[x];let g=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(s,"morphTargetBaseInfluence",g),c.getUniforms().setValue(s,"morphTargetInfluences",l)}c.getUniforms().setValue(s,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(s,"morphTargetsTextureSize",d.size)}return{update:r}}function v_(s,t,e,i,n){let r=new WeakMap;function o(l){let h=n.render.frame,u=l.geometry,d=t.get(l,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,s.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,s.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var S_={[Cl]:"LINEAR_TONE_MAPPING",[Rl]:"REINHARD_TONE_MAPPING",[Pl]:"CINEON_TONE_MAPPING",[Il]:"ACES_FILMIC_TONE_MAPPING",[Ll]:"AGX_TONE_MAPPING",[Nl]:"NEUTRAL_TONE_MAPPING",[Dl]:"CUSTOM_TONE_MAPPING"};function M_(s,t,e,i,n,r){let o=new ai(t,e,{type:s,depthBuffer:n,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Kt;h.setAttribute("position",new oe([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new oe([0,2,0,0,2,0],2));let u=new Yo({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Me(h,u),f=new Sr(-1,1,1,-1,0,1),g=null,x=null,p=!1,m,S=null,C=[],b=!1;this.setSize=function(A,E){o.setSize(A,E),a!==null&&a.setSize(A,E),c!==null&&c.setSize(A,E);for(let _=0;_<C.length;_++){let M=C[_];M.setSize&&M.setSize(A,E)}},this.setEffects=function(A){C=A,b=C.length>0&&C[0].isRenderPass===!0;let E=o.width,_=o.height;C.length>0&&a===null&&(a=new ai(E,_,{type:Pi,depthBuffer:!1,stencilBuffer:!1}),c=new ai(E,_,{type:Pi,depthBuffer:!1,stencilBuffer:!1}));let M=n===!0&&C.some(F=>F.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&l===null&&(l=new tn(E,_),r===!0&&(l.format=nn,l.type=Yn)),o.dispose(),o.depthTexture=M?l:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let F=0;F<C.length;F++){let P=C[F];P.setSize&&P.setSize(E,_),M&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(l)}},this.begin=function(A,E){if(p||A.toneMapping===Ui&&C.length===0)return!1;if(S=E,E!==null){let _=E.width,M=E.height;(o.width!==_||o.height!==M)&&this.setSize(_,M)}return b===!1&&A.setRenderTarget(o),m=A.toneMapping,A.toneMapping=Ui,!0},this.hasRenderPass=function(){return b},this.end=function(A,E){A.toneMapping=m,p=!0;let _=o,M=a;for(let F=0;F<C.length;F++){let P=C[F];P.enabled!==!1&&(P.render(A,M,_,E),P.needsSwap!==!1&&(_=M,M=M===a?c:a))}if(g!==A.outputColorSpace||x!==A.toneMapping){g=A.outputColorSpace,x=A.toneMapping,u.defines={},$t.getTransfer(g)===se&&(u.defines.SRGB_TRANSFER="");let F=S_[x];F&&(u.defines[F]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(S),A.render(d,f),S=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),u.dispose()}}var Kd=new Je,jd=new tn(1,1),Qd=new lr(1),tf=new er,ef=new Ho,nf=new ar,Pd=[],Id=[],Dd=new Float32Array(16),Ld=new Float32Array(9),Nd=new Float32Array(4);function Ls(s,t,e){let i=s[0];if(i<=0||i>0)return s;let n=t*e,r=Pd[n];if(r===void 0&&(r=new Float32Array(n),Pd[n]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,s[o].toArray(r,a)}return r}function Ee(s,t){if(s.length!==t.length)return!1;for(let e=0,i=s.length;e<i;e++)if(s[e]!==t[e])return!1;return!0}function Ae(s,t){for(let e=0,i=t.length;e<i;e++)s[e]=t[e]}function tc(s,t){let e=Id[t];e===void 0&&(e=new Int32Array(t),Id[t]=e);for(let i=0;i!==t;++i)e[i]=s.allocateTextureUnit();return e}function b_(s,t){let e=this.cache;e[0]!==t&&(s.uniform1f(this.addr,t),e[0]=t)}function w_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ee(e,t))return;s.uniform2fv(this.addr,t),Ae(e,t)}}function E_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(s.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Ee(e,t))return;s.uniform3fv(this.addr,t),Ae(e,t)}}function A_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ee(e,t))return;s.uniform4fv(this.addr,t),Ae(e,t)}}function T_(s,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ee(e,t))return;s.uniformMatrix2fv(this.addr,!1,t),Ae(e,t)}else{if(Ee(e,i))return;Nd.set(i),s.uniformMatrix2fv(this.addr,!1,Nd),Ae(e,i)}}function C_(s,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ee(e,t))return;s.uniformMatrix3fv(this.addr,!1,t),Ae(e,t)}else{if(Ee(e,i))return;Ld.set(i),s.uniformMatrix3fv(this.addr,!1,Ld),Ae(e,i)}}function R_(s,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ee(e,t))return;s.uniformMatrix4fv(this.addr,!1,t),Ae(e,t)}else{if(Ee(e,i))return;Dd.set(i),s.uniformMatrix4fv(this.addr,!1,Dd),Ae(e,i)}}function P_(s,t){let e=this.cache;e[0]!==t&&(s.uniform1i(this.addr,t),e[0]=t)}function I_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ee(e,t))return;s.uniform2iv(this.addr,t),Ae(e,t)}}function D_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ee(e,t))return;s.uniform3iv(this.addr,t),Ae(e,t)}}function L_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ee(e,t))return;s.uniform4iv(this.addr,t),Ae(e,t)}}function N_(s,t){let e=this.cache;e[0]!==t&&(s.uniform1ui(this.addr,t),e[0]=t)}function F_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ee(e,t))return;s.uniform2uiv(this.addr,t),Ae(e,t)}}function B_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ee(e,t))return;s.uniform3uiv(this.addr,t),Ae(e,t)}}function O_(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ee(e,t))return;s.uniform4uiv(this.addr,t),Ae(e,t)}}function ec(s){return s.version===0&&(s.compareFunction=Wl,s.needsUpdate=!0),s}function U_(s,t,e){let i=this.cache,n=e.allocateTextureUnit();i[0]!==n&&(s.uniform1i(this.addr,n),i[0]=n);let r;this.type===s.SAMPLER_2D_SHADOW?r=ec(jd):r=Kd,e.setTexture2D(t||r,n)}function k_(s,t,e){let i=this.cache,n=e.allocateTextureUnit();i[0]!==n&&(s.uniform1i(this.addr,n),i[0]=n),e.setTexture3D(t||ef,n)}function z_(s,t,e){let i=this.cache,n=e.allocateTextureUnit();i[0]!==n&&(s.uniform1i(this.addr,n),i[0]=n);let r;this.type===s.SAMPLER_CUBE_SHADOW?r=ec(Qd):r=nf,e.setTextureCube(t||r,n)}function G_(s,t,e){let i=this.cache,n=e.allocateTextureUnit();i[0]!==n&&(s.uniform1i(this.addr,n),i[0]=n),e.setTexture2DArray(t||tf,n)}function V_(s){switch(s){case 5126:return b_;case 35664:return w_;case 35665:return E_;case 35666:return A_;case 35674:return T_;case 35675:return C_;case 35676:return R_;case 5124:case 35670:return P_;case 35667:case 35671:return I_;case 35668:case 35672:return D_;case 35669:case 35673:return L_;case 5125:return N_;case 36294:return F_;case 36295:return B_;case 36296:return O_;case 35678:case 36198:case 36298:case 36306:case 35682:return U_;case 35679:case 36299:case 36307:return k_;case 35680:case 36300:case 36308:case 36293:return z_;case 36289:case 36303:case 36311:case 36292:return G_}}function H_(s,t){s.uniform1fv(this.addr,t)}function W_(s,t){let e=Ls(t,this.size,2);s.uniform2fv(this.addr,e)}function X_(s,t){let e=Ls(t,this.size,3);s.uniform3fv(this.addr,e)}function q_(s,t){let e=Ls(t,this.size,4);s.uniform4fv(this.addr,e)}function Y_(s,t){let e=Ls(t,this.size,4);s.uniformMatrix2fv(this.addr,!1,e)}function $_(s,t){let e=Ls(t,this.size,9);s.uniformMatrix3fv(this.addr,!1,e)}function Z_(s,t){let e=Ls(t,this.size,16);s.uniformMatrix4fv(this.addr,!1,e)}function J_(s,t){s.uniform1iv(this.addr,t)}function K_(s,t){s.uniform2iv(this.addr,t)}function j_(s,t){s.uniform3iv(this.addr,t)}function Q_(s,t){s.uniform4iv(this.addr,t)}function tx(s,t){s.uniform1uiv(this.addr,t)}function ex(s,t){s.uniform2uiv(this.addr,t)}function ix(s,t){s.uniform3uiv(this.addr,t)}function nx(s,t){s.uniform4uiv(this.addr,t)}function sx(s,t,e){let i=this.cache,n=t.length,r=tc(e,n);Ee(i,r)||(s.uniform1iv(this.addr,r),Ae(i,r));let o;this.type===s.SAMPLER_2D_SHADOW?o=ec(jd):o=Kd;for(let a=0;a!==n;++a)e.setTexture2D(t[a]||o,r[a])}function rx(s,t,e){let i=this.cache,n=t.length,r=tc(e,n);Ee(i,r)||(s.uniform1iv(this.addr,r),Ae(i,r));for(let o=0;o!==n;++o)e.setTexture3D(t[o]||ef,r[o])}function ox(s,t,e){let i=this.cache,n=t.length,r=tc(e,n);Ee(i,r)||(s.uniform1iv(this.addr,r),Ae(i,r));let o;this.type===s.SAMPLER_CUBE_SHADOW?o=ec(Qd):o=nf;for(let a=0;a!==n;++a)e.setTextureCube(t[a]||o,r[a])}function ax(s,t,e){let i=this.cache,n=t.length,r=tc(e,n);Ee(i,r)||(s.uniform1iv(this.addr,r),Ae(i,r));for(let o=0;o!==n;++o)e.setTexture2DArray(t[o]||tf,r[o])}function cx(s){switch(s){case 5126:return H_;case 35664:return W_;case 35665:return X_;case 35666:return q_;case 35674:return Y_;case 35675:return $_;case 35676:return Z_;case 5124:case 35670:return J_;case 35667:case 35671:return K_;case 35668:case 35672:return j_;case 35669:case 35673:return Q_;case 5125:return tx;case 36294:return ex;case 36295:return ix;case 36296:return nx;case 35678:case 36198:case 36298:case 36306:case 35682:return sx;case 35679:case 36299:case 36307:return rx;case 35680:case 36300:case 36308:case 36293:return ox;case 36289:case 36303:case 36311:case 36292:return ax}}var ih=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=V_(e.type)}},nh=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=cx(e.type)}},sh=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let n=this.seq;for(let r=0,o=n.length;r!==o;++r){let a=n[r];a.setValue(t,e[a.id],i)}}},th=/(\w+)(\])?(\[|\.)?/g;function Fd(s,t){s.seq.push(t),s.map[t.id]=t}function lx(s,t,e){let i=s.name,n=i.length;for(th.lastIndex=0;;){let r=th.exec(i),o=th.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===n){Fd(e,l===void 0?new ih(a,s,t):new nh(a,s,t));break}else{let u=e.map[a];u===void 0&&(u=new sh(a),Fd(e,u)),e=u}}}var Ds=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);lx(a,c,this)}let n=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?n.push(o):r.push(o);n.length>0&&(this.seq=n.concat(r))}setValue(t,e,i,n){let r=this.map[e];r!==void 0&&r.setValue(t,i,n)}setOptional(t,e,i){let n=e[i];n!==void 0&&this.setValue(t,i,n)}static upload(t,e,i,n){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,n)}}static seqWithValue(t,e){let i=[];for(let n=0,r=t.length;n!==r;++n){let o=t[n];o.id in e&&i.push(o)}return i}};function Bd(s,t,e){let i=s.createShader(t);return s.shaderSource(i,e),s.compileShader(i),i}var hx=37297,ux=0;function dx(s,t){let e=s.split(`
`),i=[],n=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=n;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Od=new Ft;function fx(s){$t._getMatrix(Od,$t.workingColorSpace,s);let t=`mat3( ${Od.elements.map(e=>e.toFixed(4))} )`;switch($t.getTransfer(s)){case Qs:return[t,"LinearTransferOETF"];case se:return[t,"sRGBTransferOETF"];default:return It("WebGLProgram: Unsupported color space: ",s),[t,"LinearTransferOETF"]}}function Ud(s,t,e){let i=s.getShaderParameter(t,s.COMPILE_STATUS),r=(s.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+dx(s.getShaderSource(t),a)}else return r}function px(s,t){let e=fx(t);return[`vec4 ${s}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var mx={[Cl]:"Linear",[Rl]:"Reinhard",[Pl]:"Cineon",[Il]:"ACESFilmic",[Ll]:"AgX",[Nl]:"Neutral",[Dl]:"Custom"};function gx(s,t){let e=mx[t];return e===void 0?(It("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+s+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+s+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Ka=new D;function _x(){$t.getLuminanceCoefficients(Ka);let s=Ka.x.toFixed(4),t=Ka.y.toFixed(4),e=Ka.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${s}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function xx(s){return[s.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",s.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Dr).join(`
`)}function yx(s){let t=[];for(let e in s){let i=s[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function vx(s,t){let e={},i=s.getProgramParameter(t,s.ACTIVE_ATTRIBUTES);for(let n=0;n<i;n++){let r=s.getActiveAttrib(t,n),o=r.name,a=1;r.type===s.FLOAT_MAT2&&(a=2),r.type===s.FLOAT_MAT3&&(a=3),r.type===s.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:s.getAttribLocation(t,o),locationSize:a}}return e}function Dr(s){return s!==""}function kd(s,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return s.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function zd(s,t){return s.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Sx=/^[ \t]*#include +<([\w\d./]+)>/gm;function rh(s){return s.replace(Sx,Mx)}function Mx(s,t){let e=Gt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return rh(e)}var bx=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Gd(s){return s.replace(bx,wx)}function wx(s,t,e,i){let n="";for(let r=parseInt(t);r<parseInt(e);r++)n+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return n}function Vd(s){let t=`precision ${s.precision} float;
	precision ${s.precision} int;
	precision ${s.precision} sampler2D;
	precision ${s.precision} samplerCube;
	precision ${s.precision} sampler3D;
	precision ${s.precision} sampler2DArray;
	precision ${s.precision} sampler2DShadow;
	precision ${s.precision} samplerCubeShadow;
	precision ${s.precision} sampler2DArrayShadow;
	precision ${s.precision} isampler2D;
	precision ${s.precision} isampler3D;
	precision ${s.precision} isamplerCube;
	precision ${s.precision} isampler2DArray;
	precision ${s.precision} usampler2D;
	precision ${s.precision} usampler3D;
	precision ${s.precision} usamplerCube;
	precision ${s.precision} usampler2DArray;
	`;return s.precision==="highp"?t+=`
#define HIGH_PRECISION`:s.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:s.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Ex={[Hn]:"SHADOWMAP_TYPE_PCF",[Ts]:"SHADOWMAP_TYPE_VSM"};function Ax(s){return Ex[s.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Tx={[Rs]:"ENVMAP_MODE_REFRACTION"};function Cx(s){return s.envMap===!1?"ENVMAP_MODE_REFLECTION":Tx[s.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Rx={[ca]:"ENVMAP_BLENDING_MULTIPLY",[sd]:"ENVMAP_BLENDING_MIX",[rd]:"ENVMAP_BLENDING_ADD"};function Px(s){return s.envMap===!1?"ENVMAP_BLENDING_NONE":Rx[s.combine]||"ENVMAP_BLENDING_NONE"}function Ix(s,t,e,i){let n=s.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=Ax(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Cx(e),u=Px(e),d=xx(e),f=yx(r),g=n.createProgram(),x,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Dr).join(`
`),x.length>0&&(x+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Dr).join(`
`),p.length>0&&(p+=`
`)):(x=[Vd(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Dr).join(`
`),p=[Vd(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Ui?"#define TONE_MAPPING":"",e.toneMapping!==Ui?Gt.tonemapping_pars_fragment:"",e.toneMapping!==Ui?gx("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Gt.colorspace_pars_fragment,px("linearToOutputTexel",e.outputColorSpace),_x(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Dr).join(`
`)),o=rh(o),o=kd(o,e),o=zd(o,e),a=rh(a),a=kd(a,e),a=zd(a,e),o=Gd(o),a=Gd(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,p=["#define varying in",e.glslVersion===Xl?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Xl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let S=m+x+o,C=m+p+a,b=Bd(n,n.VERTEX_SHADER,S),A=Bd(n,n.FRAGMENT_SHADER,C);n.attachShader(g,b),n.attachShader(g,A),e.index0AttributeName!==void 0?n.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&n.bindAttribLocation(g,0,"position"),n.linkProgram(g);function E(P){if(s.debug.checkShaderErrors){let L=n.getProgramInfoLog(g)||"",B=n.getShaderInfoLog(b)||"",z=n.getShaderInfoLog(A)||"",T=L.trim(),V=B.trim(),W=z.trim(),G=!0,Q=!0;if(n.getProgramParameter(g,n.LINK_STATUS)===!1)if(G=!1,typeof s.debug.onShaderError=="function")s.debug.onShaderError(n,g,b,A);else{let X=Ud(n,b,"vertex"),J=Ud(n,A,"fragment");Lt("WebGLProgram: Shader Error "+n.getError()+" - VALIDATE_STATUS "+n.getProgramParameter(g,n.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+T+`
`+X+`
`+J)}else T!==""?It("WebGLProgram: Program Info Log:",T):(V===""||W==="")&&(Q=!1);Q&&(P.diagnostics={runnable:G,programLog:T,vertexShader:{log:V,prefix:x},fragmentShader:{log:W,prefix:p}})}n.deleteShader(b),n.deleteShader(A),_=new Ds(n,g),M=vx(n,g)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let M;this.getAttributes=function(){return M===void 0&&E(this),M};let F=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=n.getProgramParameter(g,hx)),F},this.destroy=function(){i.releaseStatesOfProgram(this),n.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=ux++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=A,this}var Dx=0,oh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let n=this._getShaderCacheForMaterial(t);return n.has(e)===!1&&(n.add(e),e.usedTimes++),n.has(i)===!1&&(n.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new ah(t),e.set(t,i)),i}},ah=class{constructor(t){this.id=Dx++,this.code=t,this.usedTimes=0}};function Lx(s){return s===Tn||s===Rr||s===Pr}function Nx(s,t,e,i,n,r){let o=new Ss,a=new oh,c=new Set,l=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return c.add(_),_===0?"uv":`uv${_}`}function g(_,M,F,P,L,B){let z=P.fog,T=L.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,G=t.get(_.envMap||V,W),Q=d[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&It("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let J=T.morphAttributes.position||T.morphAttributes.normal||T.morphAttributes.color,tt=J!==void 0?J.length:0,yt=0;T.morphAttributes.position!==void 0&&(yt=1),T.morphAttributes.normal!==void 0&&(yt=2),T.morphAttributes.color!==void 0&&(yt=3);let Tt,Y,dt,et;if(Q){let mt=zi[Q];Tt=mt.vertexShader,Y=mt.fragmentShader}else{Tt=_.vertexShader,Y=_.fragmentShader;let mt=a.getVertexShaderStage(_),ce=a.getFragmentShaderStage(_);a.update(_,mt,ce),dt=mt.id,et=ce.id}let xt=s.getRenderTarget(),ft=s.state.buffers.depth.getReversed(),Nt=L.isInstancedMesh===!0,ge=L.isBatchedMesh===!0,Pt=!!_.map,jt=!!_.matcap,ne=!!G,Ut=ne&&G.isPMREMTexture===!0,Qt=!!_.aoMap,be=!!_.lightMap,ti=!!_.bumpMap&&_.wireframe===!1,_e=!!_.normalMap,Di=!!_.displacementMap,Ce=!!_.emissiveMap,ui=!!_.metalnessMap,di=!!_.roughnessMap,fi=_.anisotropy>0,N=_.clearcoat>0,pi=_.diffuseRoughness>0,fe=_.dispersion>0,pe=_.retroreflectivity>0,pt=_.iridescence>0,we=_.sheen>0,Dt=_.transmission>0,Bt=fi&&!!_.anisotropyMap,w=N&&!!_.clearcoatMap,y=N&&!!_.clearcoatNormalMap,U=N&&!!_.clearcoatRoughnessMap,it=pi&&!!_.diffuseRoughnessMap,j=pt&&!!_.iridescenceMap,rt=pt&&!!_.iridescenceThicknessMap,ht=we&&!!_.sheenColorMap,$=we&&!!_.sheenRoughnessMap,Z=!!_.specularMap,at=!!_.specularColorMap,R=!!_.specularIntensityMap,K=Dt&&!!_.transmissionMap,q=Dt&&!!_.thicknessMap,ct=!!_.gradientMap,st=!!_.alphaMap,ot=_.alphaTest>0,wt=!!_.alphaHash,zt=!!_.extensions,nt=Ui;_.toneMapped&&(xt===null||xt.isXRRenderTarget===!0)&&(nt=s.toneMapping);let Ct=Ut?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,kt={shaderID:Q,shaderType:_.type,shaderName:_.name,vertexShader:Tt,fragmentShader:Y,defines:_.defines,customVertexShaderID:dt,customFragmentShaderID:et,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:ge,batchingColor:ge&&L._colorsTexture!==null,instancing:Nt,instancingColor:Nt&&L.instanceColor!==null,instancingMorph:Nt&&L.morphTexture!==null,outputColorSpace:xt===null?s.outputColorSpace:xt.isXRRenderTarget===!0?xt.texture.colorSpace:$t.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Pt,matcap:jt,envMap:ne,envMapMode:ne&&G.mapping,envMapPMREM:Ut,envMapMaxLod:Ut?Ct.length-1:null,envMapSize:Ut?Ct[0].width:null,aoMap:Qt,lightMap:be,bumpMap:ti,normalMap:_e,displacementMap:Di,emissiveMap:Ce,normalMapObjectSpace:_e&&_.normalMapType===cd,normalMapTangentSpace:_e&&_.normalMapType===Za,packedNormalMap:_e&&_.normalMapType===Za&&Lx(_.normalMap.format),metalnessMap:ui,roughnessMap:di,anisotropy:fi,anisotropyMap:Bt,clearcoat:N,clearcoatMap:w,clearcoatNormalMap:y,clearcoatRoughnessMap:U,diffuseRoughness:pi,diffuseRoughnessMap:it,dispersion:fe,retroreflection:pe,iridescence:pt,iridescenceMap:j,iridescenceThicknessMap:rt,sheen:we,sheenColorMap:ht,sheenRoughnessMap:$,specularMap:Z,specularColorMap:at,specularIntensityMap:R,transmission:Dt,transmissionMap:K,thicknessMap:q,gradientMap:ct,opaque:_.transparent===!1&&_.blending===Cs&&_.alphaToCoverage===!1,alphaMap:st,alphaTest:ot,alphaHash:wt,combine:_.combine,mapUv:Pt&&f(_.map.channel),aoMapUv:Qt&&f(_.aoMap.channel),lightMapUv:be&&f(_.lightMap.channel),bumpMapUv:ti&&f(_.bumpMap.channel),normalMapUv:_e&&f(_.normalMap.channel),displacementMapUv:Di&&f(_.displacementMap.channel),emissiveMapUv:Ce&&f(_.emissiveMap.channel),metalnessMapUv:ui&&f(_.metalnessMap.channel),roughnessMapUv:di&&f(_.roughnessMap.channel),anisotropyMapUv:Bt&&f(_.anisotropyMap.channel),clearcoatMapUv:w&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:y&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:U&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:it&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:j&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:rt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:ht&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:$&&f(_.sheenRoughnessMap.channel),specularMapUv:Z&&f(_.specularMap.channel),specularColorMapUv:at&&f(_.specularColorMap.channel),specularIntensityMapUv:R&&f(_.specularIntensityMap.channel),transmissionMapUv:K&&f(_.transmissionMap.channel),thicknessMapUv:q&&f(_.thicknessMap.channel),alphaMapUv:st&&f(_.alphaMap.channel),vertexTangents:!!T.attributes.tangent&&(_e||fi),vertexNormals:!!T.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!T.attributes.color&&T.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!T.attributes.uv&&(Pt||st),fog:!!z,useFog:_.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||T.attributes.normal===void 0&&_e===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:ft,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:T.attributes.position!==void 0,morphTargets:T.morphAttributes.position!==void 0,morphNormals:T.morphAttributes.normal!==void 0,morphColors:T.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:yt,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:B.filter(mt=>mt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:s.shadowMap.enabled&&F.length>0,shadowMapType:s.shadowMap.type,toneMapping:nt,decodeVideoTexture:Pt&&_.map.isVideoTexture===!0&&$t.getTransfer(_.map.colorSpace)===se,decodeVideoTextureEmissive:Ce&&_.emissiveMap.isVideoTexture===!0&&$t.getTransfer(_.emissiveMap.colorSpace)===se,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===He,flipSided:_.side===Ke,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:zt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(zt&&_.extensions.multiDraw===!0||ge)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return kt.vertexUv1s=c.has(1),kt.vertexUv2s=c.has(2),kt.vertexUv3s=c.has(3),c.clear(),kt}function x(_){let M=[];if(_.shaderID?M.push(_.shaderID):(M.push(_.customVertexShaderID),M.push(_.customFragmentShaderID)),_.defines!==void 0)for(let F in _.defines)M.push(F),M.push(_.defines[F]);return _.isRawShaderMaterial===!1&&(p(M,_),m(M,_),M.push(s.outputColorSpace)),M.push(_.customProgramCacheKey),M.join()}function p(_,M){_.push(M.precision),_.push(M.outputColorSpace),_.push(M.envMapMode),_.push(M.envMapPMREM),_.push(M.envMapMaxLod),_.push(M.envMapSize),_.push(M.mapUv),_.push(M.alphaMapUv),_.push(M.lightMapUv),_.push(M.aoMapUv),_.push(M.bumpMapUv),_.push(M.normalMapUv),_.push(M.displacementMapUv),_.push(M.emissiveMapUv),_.push(M.metalnessMapUv),_.push(M.roughnessMapUv),_.push(M.anisotropyMapUv),_.push(M.clearcoatMapUv),_.push(M.clearcoatNormalMapUv),_.push(M.clearcoatRoughnessMapUv),_.push(M.diffuseRoughnessMapUv),_.push(M.iridescenceMapUv),_.push(M.iridescenceThicknessMapUv),_.push(M.sheenColorMapUv),_.push(M.sheenRoughnessMapUv),_.push(M.specularMapUv),_.push(M.specularColorMapUv),_.push(M.specularIntensityMapUv),_.push(M.transmissionMapUv),_.push(M.thicknessMapUv),_.push(M.combine),_.push(M.fogExp2),_.push(M.sizeAttenuation),_.push(M.morphTargetsCount),_.push(M.numSunLights),_.push(M.numDirLights),_.push(M.numPointLights),_.push(M.numSpotLights),_.push(M.numSpotLightMaps),_.push(M.numHemiLights),_.push(M.numRectAreaLights),_.push(M.numSunLightShadows),_.push(M.numDirLightShadows),_.push(M.numPointLightShadows),_.push(M.numSpotLightShadows),_.push(M.numSpotLightShadowsWithMaps),_.push(M.numLightProbes),_.push(M.numLightProbeGrids),_.push(M.shadowMapType),_.push(M.toneMapping),_.push(M.numClippingPlanes),_.push(M.numClipIntersection),_.push(M.depthPacking)}function m(_,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function S(_){let M=d[_.type],F;if(M){let P=zi[M];F=bd.clone(P.uniforms)}else F=_.uniforms;return F}function C(_,M){let F=h.get(M);return F!==void 0?++F.usedTimes:(F=new Ix(s,M,_,n),l.push(F),h.set(M,F)),F}function b(_){if(--_.usedTimes===0){let M=l.indexOf(_);l[M]=l[l.length-1],l.pop(),h.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:S,acquireProgram:C,releaseProgram:b,releaseShaderCache:A,programs:l,dispose:E}}function Fx(){let s=new WeakMap;function t(o){return s.has(o)}function e(o){let a=s.get(o);return a===void 0&&(a={},s.set(o,a)),a}function i(o){s.delete(o)}function n(o,a,c){s.get(o)[a]=c}function r(){s=new WeakMap}return{has:t,get:e,remove:i,update:n,dispose:r}}function Bx(s,t){return s.groupOrder!==t.groupOrder?s.groupOrder-t.groupOrder:s.renderOrder!==t.renderOrder?s.renderOrder-t.renderOrder:s.material.id!==t.material.id?s.material.id-t.material.id:s.materialVariant!==t.materialVariant?s.materialVariant-t.materialVariant:s.z!==t.z?s.z-t.z:s.id-t.id}function Hd(s,t){return s.groupOrder!==t.groupOrder?s.groupOrder-t.groupOrder:s.renderOrder!==t.renderOrder?s.renderOrder-t.renderOrder:s.z!==t.z?t.z-s.z:s.id-t.id}function Wd(){let s=[],t=0,e=[],i=[],n=[];function r(){t=0,e.length=0,i.length=0,n.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,x,p,m){let S=s[t];return S===void 0?(S={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:p,group:m},s[t]=S):(S.id=d.id,S.object=d,S.geometry=f,S.material=g,S.materialVariant=o(d),S.groupOrder=x,S.renderOrder=d.renderOrder,S.z=p,S.group=m),t++,S}function c(d,f,g,x,p,m,S){S.reversedDepth===!0&&(p=-p);let C=a(d,f,g,x,p,m);g.transmission>0?i.push(C):g.transparent===!0?n.push(C):e.push(C)}function l(d,f,g,x,p,m){let S=a(d,f,g,x,p,m);g.transmission>0?i.unshift(S):g.transparent===!0?n.unshift(S):e.unshift(S)}function h(d,f){e.length>1&&e.sort(d||Bx),i.length>1&&i.sort(f||Hd),n.length>1&&n.sort(f||Hd)}function u(){for(let d=t,f=s.length;d<f;d++){let g=s[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:n,init:r,push:c,unshift:l,finish:u,sort:h}}function Ox(){let s=new WeakMap;function t(i,n){let r=s.get(i),o;return r===void 0?(o=new Wd,s.set(i,[o])):n>=r.length?(o=new Wd,r.push(o)):o=r[n],o}function e(){s=new WeakMap}return{get:t,dispose:e}}function Ux(){let s={};return{get:function(t){if(s[t.id]!==void 0)return s[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new D,color:new At};break;case"SpotLight":e={position:new D,direction:new D,color:new At,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new D,color:new At,distance:0,decay:0};break;case"HemisphereLight":e={direction:new D,skyColor:new At,groundColor:new At};break;case"RectAreaLight":e={color:new At,position:new D,halfWidth:new D,halfHeight:new D};break}return s[t.id]=e,e}}}function kx(){let s={};return{get:function(t){if(s[t.id]!==void 0)return s[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt,shadowCameraNear:1,shadowCameraFar:1e3};break}return s[t.id]=e,e}}}var zx=0;function Gx(s,t){return(t.castShadow?2:0)-(s.castShadow?2:0)+(t.map?1:0)-(s.map?1:0)}function Vx(s){let t=new Ux,e=kx(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new D);let n=new D,r=new re,o=new re;function a(l){let h=0,u=0,d=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let f=0,g=0,x=0,p=0,m=0,S=0,C=0,b=0,A=0,E=0,_=0,M=0,F=0,P=0;l.sort(Gx);for(let B=0,z=l.length;B<z;B++){let T=l[B],V=T.color,W=T.intensity,G=T.distance,Q=null;if(T.shadow&&T.shadow.map&&(T.shadow.map.texture.format===Tn?Q=T.shadow.map.texture:Q=T.shadow.map.depthTexture||T.shadow.map.texture),T.isAmbientLight)h+=V.r*W,u+=V.g*W,d+=V.b*W;else if(T.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(T.sh.coefficients[X],W);P++}else if(T.isSunLight){let X=t.get(T);if(X.color.copy(T.color).multiplyScalar(T.intensity),T.castShadow){let J=T.shadow,tt=e.get(T);tt.shadowIntensity=J.intensity,tt.shadowBias=J.bias,tt.shadowNormalBias=J.normalBias,tt.shadowRadius=J.radius,tt.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[g]=tt,i.sunShadowMap[g]=Q;let yt=J.getViewportCount();for(let Tt=0;Tt<yt;Tt++)i.sunShadowMatrix[x+Tt]=J.getMatrix(Tt),i.sunShadowCascade[x+Tt]=J._cascadeData[Tt];x+=yt,g++}i.sun[f]=X,f++}else if(T.isDirectionalLight){let X=t.get(T);if(X.color.copy(T.color).multiplyScalar(T.intensity),T.castShadow){let J=T.shadow,tt=e.get(T);tt.shadowIntensity=J.intensity,tt.shadowBias=J.bias,tt.shadowNormalBias=J.normalBias,tt.shadowRadius=J.radius,tt.shadowMapSize=J.mapSize,i.directionalShadow[p]=tt,i.directionalShadowMap[p]=Q,i.directionalShadowMatrix[p]=T.shadow.matrix,A++}i.directional[p]=X,p++}else if(T.isSpotLight){let X=t.get(T);X.position.setFromMatrixPosition(T.matrixWorld),X.color.copy(V).multiplyScalar(W),X.distance=G,X.coneCos=Math.cos(T.angle),X.penumbraCos=Math.cos(T.angle*(1-T.penumbra)),X.decay=T.decay,i.spot[S]=X;let J=T.shadow;if(T.map&&(i.spotLightMap[M]=T.map,M++,J.updateMatrices(T),T.castShadow&&F++),i.spotLightMatrix[S]=J.matrix,T.castShadow){let tt=e.get(T);tt.shadowIntensity=J.intensity,tt.shadowBias=J.bias,tt.shadowNormalBias=J.normalBias,tt.shadowRadius=J.radius,tt.shadowMapSize=J.mapSize,i.spotShadow[S]=tt,i.spotShadowMap[S]=Q,_++}S++}else if(T.isRectAreaLight){let X=t.get(T);X.color.copy(V).multiplyScalar(W),X.halfWidth.set(T.width*.5,0,0),X.halfHeight.set(0,T.height*.5,0),i.rectArea[C]=X,C++}else if(T.isPointLight){let X=t.get(T);if(X.color.copy(T.color).multiplyScalar(T.intensity),X.distance=T.distance,X.decay=T.decay,T.castShadow){let J=T.shadow,tt=e.get(T);tt.shadowIntensity=J.intensity,tt.shadowBias=J.bias,tt.shadowNormalBias=J.normalBias,tt.shadowRadius=J.radius,tt.shadowMapSize=J.mapSize,tt.shadowCameraNear=J.camera.near,tt.shadowCameraFar=J.camera.far,i.pointShadow[m]=tt,i.pointShadowMap[m]=Q,i.pointShadowMatrix[m]=T.shadow.matrix,E++}i.point[m]=X,m++}else if(T.isHemisphereLight){let X=t.get(T);X.skyColor.copy(T.color).multiplyScalar(W),X.groundColor.copy(T.groundColor).multiplyScalar(W),i.hemi[b]=X,b++}}C>0&&(s.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=gt.LTC_FLOAT_1,i.rectAreaLTC2=gt.LTC_FLOAT_2):(i.rectAreaLTC1=gt.LTC_HALF_1,i.rectAreaLTC2=gt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let L=i.hash;(L.sunLength!==f||L.directionalLength!==p||L.pointLength!==m||L.spotLength!==S||L.rectAreaLength!==C||L.hemiLength!==b||L.numSunShadows!==g||L.numDirectionalShadows!==A||L.numPointShadows!==E||L.numSpotShadows!==_||L.numSpotMaps!==M||L.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=p,i.spot.length=S,i.rectArea.length=C,i.point.length=m,i.hemi.length=b,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+M-F,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=F,i.numLightProbes=P,L.sunLength=f,L.directionalLength=p,L.pointLength=m,L.spotLength=S,L.rectAreaLength=C,L.hemiLength=b,L.numSunShadows=g,L.numDirectionalShadows=A,L.numPointShadows=E,L.numSpotShadows=_,L.numSpotMaps=M,L.numLightProbes=P,i.version=zx++)}function c(l,h){let u=0,d=0,f=0,g=0,x=0,p=0,m=h.matrixWorldInverse;for(let S=0,C=l.length;S<C;S++){let b=l[S];if(b.isSunLight){let A=i.sun[u];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(m),u++}else if(b.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(b.matrixWorld),n.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(n),A.direction.transformDirection(m),d++}else if(b.isSpotLight){let A=i.spot[g];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(b.matrixWorld),n.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(n),A.direction.transformDirection(m),g++}else if(b.isRectAreaLight){let A=i.rectArea[x];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let A=i.hemi[p];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(m),p++}}}return{setup:a,setupView:c,state:i}}function Xd(s){let t=new Vx(s),e=[],i=[],n=[];function r(u){h.camera=u,e.length=0,i.length=0,n.length=0}function o(u){u.isLightProbeGrid?n.push(u):e.push(u)}function a(u){i.push(u)}function c(){t.setup(e),n.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function l(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:n,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function Hx(s){let t=new WeakMap;function e(n,r=0){let o=t.get(n),a;return o===void 0?(a=new Xd(s),t.set(n,[a])):r>=o.length?(a=new Xd(s),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var Wx=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Xx=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,qx=[new D(1,0,0),new D(-1,0,0),new D(0,1,0),new D(0,-1,0),new D(0,0,1),new D(0,0,-1)],Yx=[new D(0,-1,0),new D(0,-1,0),new D(0,0,1),new D(0,0,-1),new D(0,-1,0),new D(0,-1,0)],qd=new re,Ir=new D,eh=new D;function $x(s,t,e){let i=new _n,n=new Rt,r=new Rt,o=new me,a=new $o,c=new Zo,l={},h=e.maxTextureSize,u={[An]:Ke,[Ke]:An,[He]:He},d=new Oi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Rt},radius:{value:4}},vertexShader:Wx,fragmentShader:Xx}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Kt;g.setAttribute("position",new ee(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Me(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Hn;let m=this.type;this.render=function(E,_,M){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===ku&&(It("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Hn);let F=s.getRenderTarget(),P=s.getActiveCubeFace(),L=s.getActiveMipmapLevel(),B=s.state;B.setBlending(Wn),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let z=m!==this.type;z&&_.traverse(function(T){T.material&&(Array.isArray(T.material)?T.material.forEach(V=>V.needsUpdate=!0):T.material.needsUpdate=!0)});for(let T=0,V=E.length;T<V;T++){let W=E[T],G=W.shadow;if(G===void 0){It("WebGLShadowMap:",W,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;n.copy(G.mapSize);let Q=G.getFrameExtents();n.multiply(Q),r.copy(G.mapSize),(n.x>h||n.y>h)&&(n.x>h&&(r.x=Math.floor(h/Q.x),n.x=r.x*Q.x,G.mapSize.x=r.x),n.y>h&&(r.y=Math.floor(h/Q.y),n.y=r.y*Q.y,G.mapSize.y=r.y));let X=s.state.buffers.depth.getReversed();if(G.camera._reversedDepth=X,G.map===null||z===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Ts){if(W.isPointLight){It("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new ai(n.x,n.y,{format:Tn,type:Pi,minFilter:Ze,magFilter:Ze,generateMipmaps:!1}),G.map.texture.name=W.name+".shadowMap",G.map.depthTexture=new tn(n.x,n.y,yi),G.map.depthTexture.name=W.name+".shadowMapDepth",G.map.depthTexture.format=Ki,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Le,G.map.depthTexture.magFilter=Le}else W.isPointLight?(G.map=new Lr(n.x),G.map.depthTexture=new lr(n.x,Ri)):(G.map=new ai(n.x,n.y),G.map.depthTexture=new tn(n.x,n.y,Ri)),G.map.depthTexture.name=W.name+".shadowMap",G.map.depthTexture.format=Ki,this.type===Hn?(G.map.depthTexture.compareFunction=X?Hl:Vl,G.map.depthTexture.minFilter=Ze,G.map.depthTexture.magFilter=Ze):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Le,G.map.depthTexture.magFilter=Le);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==n.x||G.map.height!==n.y)&&G.map.setSize(n.x,n.y);let J=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();W.isPointLight!==!0&&G.updateMatrices(W,M);let tt=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:M.layers;for(let yt=0;yt<J;yt++){let Tt=G.getCamera(yt);if(W.isPointLight){let Y=G.camera,dt=G.matrix,et=W.distance||Y.far;et!==Y.far&&(Y.far=et,Y.updateProjectionMatrix()),Ir.setFromMatrixPosition(W.matrixWorld),Y.position.copy(Ir),eh.copy(Y.position),eh.add(qx[yt]),Y.up.copy(Yx[yt]),Y.lookAt(eh),Y.updateMatrixWorld(),dt.makeTranslation(-Ir.x,-Ir.y,-Ir.z),qd.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),G._frustum.setFromProjectionMatrix(qd,Y.coordinateSystem,Y.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)s.setRenderTarget(G.map,yt),s.clear();else{yt===0&&(s.setRenderTarget(G.map),s.clear());let Y=G.getViewport(yt);o.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),B.viewport(o)}i=G.getFrustum(yt),b(_,M,Tt,W,tt,this.type)}G.isPointLightShadow!==!0&&this.type===Ts&&S(G,M),G.needsUpdate=!1}m=this.type,p.needsUpdate=!1,s.setRenderTarget(F,P,L)};function S(E,_){let M=t.update(x);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new ai(n.x,n.y,{format:Tn,type:Pi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,s.setRenderTarget(E.mapPass),s.clear(),s.renderBufferDirect(_,null,M,d,x,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,s.setRenderTarget(E.map),s.clear(),s.renderBufferDirect(_,null,M,f,x,null)}function C(E,_,M,F){let P=null,L=M.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)P=L;else if(P=M.isPointLight===!0?c:a,s.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let B=P.uuid,z=_.uuid,T=l[B];T===void 0&&(T={},l[B]=T);let V=T[z];V===void 0&&(V=P.clone(),T[z]=V,_.addEventListener("dispose",A)),P=V}if(P.visible=_.visible,P.wireframe=_.wireframe,F===Ts?P.side=_.shadowSide!==null?_.shadowSide:_.side:P.side=_.shadowSide!==null?_.shadowSide:u[_.side],P.alphaMap=_.alphaMap,P.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,P.map=_.map,P.clipShadows=_.clipShadows,P.clippingPlanes=_.clippingPlanes,P.clipIntersection=_.clipIntersection,P.displacementMap=_.displacementMap,P.displacementScale=_.displacementScale,P.displacementBias=_.displacementBias,P.wireframeLinewidth=_.wireframeLinewidth,P.linewidth=_.linewidth,M.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let B=s.properties.get(P);B.light=M}return P}function b(E,_,M,F,P,L){if(E.visible===!1)return;if(E.layers.test(P)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===Ts)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,E.matrixWorld);let T=t.update(E),V=E.material;if(Array.isArray(V)){let W=T.groups;for(let G=0,Q=W.length;G<Q;G++){let X=W[G],J=V[X.materialIndex];if(J&&J.visible){let tt=C(E,J,F,L);E.onBeforeShadow(s,E,_,M,T,tt,X),s.renderBufferDirect(M,null,T,tt,E,X),E.onAfterShadow(s,E,_,M,T,tt,X)}}}else if(V.visible){let W=C(E,V,F,L);E.onBeforeShadow(s,E,_,M,T,W,null),s.renderBufferDirect(M,null,T,W,E,null),E.onAfterShadow(s,E,_,M,T,W,null)}}let z=E.children;for(let T=0,V=z.length;T<V;T++)b(z[T],_,M,F,P,L)}function A(E){E.target.removeEventListener("dispose",A);for(let M in l){let F=l[M],P=E.target.uuid;P in F&&(F[P].dispose(),delete F[P])}}}function Zx(s,t){function e(){let R=!1,K=new me,q=null,ct=new me(0,0,0,0);return{setMask:function(st){q!==st&&!R&&(s.colorMask(st,st,st,st),q=st)},setLocked:function(st){R=st},setClear:function(st,ot,wt,zt,nt){nt===!0&&(st*=zt,ot*=zt,wt*=zt),K.set(st,ot,wt,zt),ct.equals(K)===!1&&(s.clearColor(st,ot,wt,zt),ct.copy(K))},reset:function(){R=!1,q=null,ct.set(-1,0,0,0)}}}function i(){let R=!1,K=!1,q=null,ct=null,st=null;return{setReversed:function(ot){if(K!==ot){let wt=t.get("EXT_clip_control");ot?wt.clipControlEXT(wt.LOWER_LEFT_EXT,wt.ZERO_TO_ONE_EXT):wt.clipControlEXT(wt.LOWER_LEFT_EXT,wt.NEGATIVE_ONE_TO_ONE_EXT),K=ot;let zt=st;st=null,this.setClear(zt)}},getReversed:function(){return K},setTest:function(ot){ot?ft(s.DEPTH_TEST):Nt(s.DEPTH_TEST)},setMask:function(ot){q!==ot&&!R&&(s.depthMask(ot),q=ot)},setFunc:function(ot){if(K&&(ot=yd[ot]),ct!==ot){switch(ot){case Io:s.depthFunc(s.NEVER);break;case Do:s.depthFunc(s.ALWAYS);break;case Lo:s.depthFunc(s.LESS);break;case gs:s.depthFunc(s.LEQUAL);break;case No:s.depthFunc(s.EQUAL);break;case Fo:s.depthFunc(s.GEQUAL);break;case Bo:s.depthFunc(s.GREATER);break;case Oo:s.depthFunc(s.NOTEQUAL);break;default:s.depthFunc(s.LEQUAL)}ct=ot}},setLocked:function(ot){R=ot},setClear:function(ot){st!==ot&&(st=ot,K&&(ot=1-ot),s.clearDepth(ot))},reset:function(){R=!1,q=null,ct=null,st=null,K=!1}}}function n(){let R=!1,K=null,q=null,ct=null,st=null,ot=null,wt=null,zt=null,nt=null;return{setTest:function(Ct){R||(Ct?ft(s.STENCIL_TEST):Nt(s.STENCIL_TEST))},setMask:function(Ct){K!==Ct&&!R&&(s.stencilMask(Ct),K=Ct)},setFunc:function(Ct,kt,mt){(q!==Ct||ct!==kt||st!==mt)&&(s.stencilFunc(Ct,kt,mt),q=Ct,ct=kt,st=mt)},setOp:function(Ct,kt,mt){(ot!==Ct||wt!==kt||zt!==mt)&&(s.stencilOp(Ct,kt,mt),ot=Ct,wt=kt,zt=mt)},setLocked:function(Ct){R=Ct},setClear:function(Ct){nt!==Ct&&(s.clearStencil(Ct),nt=Ct)},reset:function(){R=!1,K=null,q=null,ct=null,st=null,ot=null,wt=null,zt=null,nt=null}}}let r=new e,o=new i,a=new n,c={},l=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],x=null,p=!1,m=null,S=null,C=null,b=null,A=null,E=null,_=null,M=new At(0,0,0),F=0,P=!1,L=null,B=null,z=null,T=null,V=null,W=s.getParameter(s.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,Q=0,X=s.getParameter(s.VERSION);X.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(X)[1]),G=Q>=1):X.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),G=Q>=2);let J=null,tt={},yt=s.getParameter(s.SCISSOR_BOX),Tt=s.getParameter(s.VIEWPORT),Y=new me().fromArray(yt),dt=new me().fromArray(Tt);function et(R,K,q,ct){let st=new Uint8Array(4),ot=s.createTexture();s.bindTexture(R,ot),s.texParameteri(R,s.TEXTURE_MIN_FILTER,s.NEAREST),s.texParameteri(R,s.TEXTURE_MAG_FILTER,s.NEAREST);for(let wt=0;wt<q;wt++)R===s.TEXTURE_3D||R===s.TEXTURE_2D_ARRAY?s.texImage3D(K,0,s.RGBA,1,1,ct,0,s.RGBA,s.UNSIGNED_BYTE,st):s.texImage2D(K+wt,0,s.RGBA,1,1,0,s.RGBA,s.UNSIGNED_BYTE,st);return ot}let xt={};xt[s.TEXTURE_2D]=et(s.TEXTURE_2D,s.TEXTURE_2D,1),xt[s.TEXTURE_CUBE_MAP]=et(s.TEXTURE_CUBE_MAP,s.TEXTURE_CUBE_MAP_POSITIVE_X,6),xt[s.TEXTURE_2D_ARRAY]=et(s.TEXTURE_2D_ARRAY,s.TEXTURE_2D_ARRAY,1,1),xt[s.TEXTURE_3D]=et(s.TEXTURE_3D,s.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ft(s.DEPTH_TEST),o.setFunc(gs),ti(!1),_e(Ml),ft(s.CULL_FACE),Qt(Wn);function ft(R){h[R]!==!0&&(s.enable(R),h[R]=!0)}function Nt(R){h[R]!==!1&&(s.disable(R),h[R]=!1)}function ge(R,K){return d[R]!==K?(s.bindFramebuffer(R,K),d[R]=K,R===s.DRAW_FRAMEBUFFER&&(d[s.FRAMEBUFFER]=K),R===s.FRAMEBUFFER&&(d[s.DRAW_FRAMEBUFFER]=K),!0):!1}function Pt(R,K){let q=g,ct=!1;if(R){q=f.get(K),q===void 0&&(q=[],f.set(K,q));let st=R.textures;if(q.length!==st.length||q[0]!==s.COLOR_ATTACHMENT0){for(let ot=0,wt=st.length;ot<wt;ot++)q[ot]=s.COLOR_ATTACHMENT0+ot;q.length=st.length,ct=!0}}else q[0]!==s.BACK&&(q[0]=s.BACK,ct=!0);ct&&s.drawBuffers(q)}function jt(R){return x!==R?(s.useProgram(R),x=R,!0):!1}let ne={[Xn]:s.FUNC_ADD,[Gu]:s.FUNC_SUBTRACT,[Vu]:s.FUNC_REVERSE_SUBTRACT};ne[Hu]=s.MIN,ne[Wu]=s.MAX;let Ut={[Xu]:s.ZERO,[qu]:s.ONE,[Yu]:s.SRC_COLOR,[Al]:s.SRC_ALPHA,[Qu]:s.SRC_ALPHA_SATURATE,[Ku]:s.DST_COLOR,[Zu]:s.DST_ALPHA,[$u]:s.ONE_MINUS_SRC_COLOR,[Tl]:s.ONE_MINUS_SRC_ALPHA,[ju]:s.ONE_MINUS_DST_COLOR,[Ju]:s.ONE_MINUS_DST_ALPHA,[td]:s.CONSTANT_COLOR,[ed]:s.ONE_MINUS_CONSTANT_COLOR,[id]:s.CONSTANT_ALPHA,[nd]:s.ONE_MINUS_CONSTANT_ALPHA};function Qt(R,K,q,ct,st,ot,wt,zt,nt,Ct){if(R===Wn){p===!0&&(Nt(s.BLEND),p=!1);return}if(p===!1&&(ft(s.BLEND),p=!0),R!==zu){if(R!==m||Ct!==P){if((S!==Xn||A!==Xn)&&(s.blendEquation(s.FUNC_ADD),S=Xn,A=Xn),Ct)switch(R){case Cs:s.blendFuncSeparate(s.ONE,s.ONE_MINUS_SRC_ALPHA,s.ONE,s.ONE_MINUS_SRC_ALPHA);break;case bl:s.blendFunc(s.ONE,s.ONE);break;case wl:s.blendFuncSeparate(s.ZERO,s.ONE_MINUS_SRC_COLOR,s.ZERO,s.ONE);break;case El:s.blendFuncSeparate(s.DST_COLOR,s.ONE_MINUS_SRC_ALPHA,s.ZERO,s.ONE);break;default:Lt("WebGLState: Invalid blending: ",R);break}else switch(R){case Cs:s.blendFuncSeparate(s.SRC_ALPHA,s.ONE_MINUS_SRC_ALPHA,s.ONE,s.ONE_MINUS_SRC_ALPHA);break;case bl:s.blendFuncSeparate(s.SRC_ALPHA,s.ONE,s.ONE,s.ONE);break;case wl:Lt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case El:Lt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Lt("WebGLState: Invalid blending: ",R);break}C=null,b=null,E=null,_=null,M.set(0,0,0),F=0,m=R,P=Ct}return}st=st||K,ot=ot||q,wt=wt||ct,(K!==S||st!==A)&&(s.blendEquationSeparate(ne[K],ne[st]),S=K,A=st),(q!==C||ct!==b||ot!==E||wt!==_)&&(s.blendFuncSeparate(Ut[q],Ut[ct],Ut[ot],Ut[wt]),C=q,b=ct,E=ot,_=wt),(zt.equals(M)===!1||nt!==F)&&(s.blendColor(zt.r,zt.g,zt.b,nt),M.copy(zt),F=nt),m=R,P=!1}function be(R,K){R.side===He?Nt(s.CULL_FACE):ft(s.CULL_FACE);let q=R.side===Ke;K&&(q=!q),ti(q),R.blending===Cs&&R.transparent===!1?Qt(Wn):Qt(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),o.setFunc(R.depthFunc),o.setTest(R.depthTest),o.setMask(R.depthWrite),r.setMask(R.colorWrite);let ct=R.stencilWrite;a.setTest(ct),ct&&(a.setMask(R.stencilWriteMask),a.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),a.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),Ce(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?ft(s.SAMPLE_ALPHA_TO_COVERAGE):Nt(s.SAMPLE_ALPHA_TO_COVERAGE)}function ti(R){L!==R&&(R?s.frontFace(s.CW):s.frontFace(s.CCW),L=R)}function _e(R){R!==Ou?(ft(s.CULL_FACE),R!==B&&(R===Ml?s.cullFace(s.BACK):R===Uu?s.cullFace(s.FRONT):s.cullFace(s.FRONT_AND_BACK))):Nt(s.CULL_FACE),B=R}function Di(R){R!==z&&(G&&s.lineWidth(R),z=R)}function Ce(R,K,q){R?(ft(s.POLYGON_OFFSET_FILL),(T!==K||V!==q)&&(T=K,V=q,o.getReversed()&&(K=-K,q=-q),s.polygonOffset(K,q))):Nt(s.POLYGON_OFFSET_FILL)}function ui(R){R?ft(s.SCISSOR_TEST):Nt(s.SCISSOR_TEST)}function di(R){R===void 0&&(R=s.TEXTURE0+W-1),J!==R&&(s.activeTexture(R),J=R)}function fi(R,K,q){q===void 0&&(J===null?q=s.TEXTURE0+W-1:q=J);let ct=tt[q];ct===void 0&&(ct={type:void 0,texture:void 0},tt[q]=ct),(ct.type!==R||ct.texture!==K)&&(J!==q&&(s.activeTexture(q),J=q),s.bindTexture(R,K||xt[R]),ct.type=R,ct.texture=K)}function N(){let R=tt[J];R!==void 0&&R.type!==void 0&&(s.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function pi(){try{s.compressedTexImage2D(...arguments)}catch(R){Lt("WebGLState:",R)}}function fe(){try{s.compressedTexImage3D(...arguments)}catch(R){Lt("WebGLState:",R)}}function pe(){try{s.texSubImage2D(...arguments)}catch(R){Lt("WebGLState:",R)}}function pt(){try{s.texSubImage3D(...arguments)}catch(R){Lt("WebGLState:",R)}}function we(){try{s.compressedTexSubImage2D(...arguments)}catch(R){Lt("WebGLState:",R)}}function Dt(){try{s.compressedTexSubImage3D(...arguments)}catch(R){Lt("WebGLState:",R)}}function Bt(){try{s.texStorage2D(...arguments)}catch(R){Lt("WebGLState:",R)}}function w(){try{s.texStorage3D(...arguments)}catch(R){Lt("WebGLState:",R)}}function y(){try{s.texImage2D(...arguments)}catch(R){Lt("WebGLState:",R)}}function U(){try{s.texImage3D(...arguments)}catch(R){Lt("WebGLState:",R)}}function it(R){return u[R]!==void 0?u[R]:s.getParameter(R)}function j(R,K){u[R]!==K&&(s.pixelStorei(R,K),u[R]=K)}function rt(R){Y.equals(R)===!1&&(s.scissor(R.x,R.y,R.z,R.w),Y.copy(R))}function ht(R){dt.equals(R)===!1&&(s.viewport(R.x,R.y,R.z,R.w),dt.copy(R))}function $(R,K){let q=l.get(K);q===void 0&&(q=new WeakMap,l.set(K,q));let ct=q.get(R);ct===void 0&&(ct=s.getUniformBlockIndex(K,R.name),s.uniformBlockBinding(K,ct,ct),q.set(R,ct))}function Z(R,K,q){let st=l.get(K).get(R);c[st]!==q&&(s.bindBufferBase(s.UNIFORM_BUFFER,st,q),c[st]=q)}function at(){s.disable(s.BLEND),s.disable(s.CULL_FACE),s.disable(s.DEPTH_TEST),s.disable(s.POLYGON_OFFSET_FILL),s.disable(s.SCISSOR_TEST),s.disable(s.STENCIL_TEST),s.disable(s.SAMPLE_ALPHA_TO_COVERAGE),s.blendEquation(s.FUNC_ADD),s.blendFunc(s.ONE,s.ZERO),s.blendFuncSeparate(s.ONE,s.ZERO,s.ONE,s.ZERO),s.blendColor(0,0,0,0),s.colorMask(!0,!0,!0,!0),s.clearColor(0,0,0,0),s.depthMask(!0),s.depthFunc(s.LESS),o.setReversed(!1),s.clearDepth(1),s.stencilMask(4294967295),s.stencilFunc(s.ALWAYS,0,4294967295),s.stencilOp(s.KEEP,s.KEEP,s.KEEP),s.clearStencil(0),s.cullFace(s.BACK),s.frontFace(s.CCW),s.polygonOffset(0,0),s.activeTexture(s.TEXTURE0),s.bindFramebuffer(s.FRAMEBUFFER,null),s.bindFramebuffer(s.DRAW_FRAMEBUFFER,null),s.bindFramebuffer(s.READ_FRAMEBUFFER,null),s.useProgram(null),s.lineWidth(1),s.scissor(0,0,s.canvas.width,s.canvas.height),s.viewport(0,0,s.canvas.width,s.canvas.height),s.pixelStorei(s.PACK_ALIGNMENT,4),s.pixelStorei(s.UNPACK_ALIGNMENT,4),s.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,!1),s.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),s.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,s.BROWSER_DEFAULT_WEBGL),s.pixelStorei(s.PACK_ROW_LENGTH,0),s.pixelStorei(s.PACK_SKIP_PIXELS,0),s.pixelStorei(s.PACK_SKIP_ROWS,0),s.pixelStorei(s.UNPACK_ROW_LENGTH,0),s.pixelStorei(s.UNPACK_IMAGE_HEIGHT,0),s.pixelStorei(s.UNPACK_SKIP_PIXELS,0),s.pixelStorei(s.UNPACK_SKIP_ROWS,0),s.pixelStorei(s.UNPACK_SKIP_IMAGES,0),h={},u={},J=null,tt={},d={},c={},f=new WeakMap,g=[],x=null,p=!1,m=null,S=null,C=null,b=null,A=null,E=null,_=null,M=new At(0,0,0),F=0,P=!1,L=null,B=null,z=null,T=null,V=null,Y.set(0,0,s.canvas.width,s.canvas.height),dt.set(0,0,s.canvas.width,s.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ft,disable:Nt,bindFramebuffer:ge,drawBuffers:Pt,useProgram:jt,setBlending:Qt,setMaterial:be,setFlipSided:ti,setCullFace:_e,setLineWidth:Di,setPolygonOffset:Ce,setScissorTest:ui,activeTexture:di,bindTexture:fi,unbindTexture:N,compressedTexImage2D:pi,compressedTexImage3D:fe,texImage2D:y,texImage3D:U,pixelStorei:j,getParameter:it,updateUBOMapping:$,uniformBlockBinding:Z,texStorage2D:Bt,texStorage3D:w,texSubImage2D:pe,texSubImage3D:pt,compressedTexSubImage2D:we,compressedTexSubImage3D:Dt,scissor:rt,viewport:ht,reset:at}}function Jx(s,t,e,i,n,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Rt,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,x=new FinalizationRegistry(w=>g.delete(w)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(w,y){return p?new OffscreenCanvas(w,y):tr("canvas")}function S(w,y,U){let it=1,j=Bt(w);if((j.width>U||j.height>U)&&(it=U/Math.max(j.width,j.height)),it<1)if(typeof HTMLImageElement<"u"&&w instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&w instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&w instanceof ImageBitmap||typeof VideoFrame<"u"&&w instanceof VideoFrame){let rt=Math.floor(it*j.width),ht=Math.floor(it*j.height);d===void 0&&(d=m(rt,ht));let $=y?m(rt,ht):d;return $.width=rt,$.height=ht,$.getContext("2d").drawImage(w,0,0,rt,ht),It("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+rt+"x"+ht+")."),$}else return"data"in w&&It("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),w;return w}function C(w){return w.generateMipmaps}function b(w){s.generateMipmap(w)}function A(w){return w.isWebGLCubeRenderTarget?s.TEXTURE_CUBE_MAP:w.isWebGL3DRenderTarget?s.TEXTURE_3D:w.isWebGLArrayRenderTarget||w.isCompressedArrayTexture?s.TEXTURE_2D_ARRAY:s.TEXTURE_2D}function E(w,y,U,it,j,rt=!1){if(w!==null){if(s[w]!==void 0)return s[w];It("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+w+"'")}let ht;it&&(ht=t.get("EXT_texture_norm16"),ht||It("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let $=y;if(y===s.RED&&(U===s.FLOAT&&($=s.R32F),U===s.HALF_FLOAT&&($=s.R16F),U===s.UNSIGNED_BYTE&&($=s.R8),U===s.UNSIGNED_SHORT&&ht&&($=ht.R16_EXT),U===s.SHORT&&ht&&($=ht.R16_SNORM_EXT)),y===s.RED_INTEGER&&(U===s.UNSIGNED_BYTE&&($=s.R8UI),U===s.UNSIGNED_SHORT&&($=s.R16UI),U===s.UNSIGNED_INT&&($=s.R32UI),U===s.BYTE&&($=s.R8I),U===s.SHORT&&($=s.R16I),U===s.INT&&($=s.R32I)),y===s.RG&&(U===s.FLOAT&&($=s.RG32F),U===s.HALF_FLOAT&&($=s.RG16F),U===s.UNSIGNED_BYTE&&($=s.RG8),U===s.UNSIGNED_SHORT&&ht&&($=ht.RG16_EXT),U===s.SHORT&&ht&&($=ht.RG16_SNORM_EXT)),y===s.RG_INTEGER&&(U===s.UNSIGNED_BYTE&&($=s.RG8UI),U===s.UNSIGNED_SHORT&&($=s.RG16UI),U===s.UNSIGNED_INT&&($=s.RG32UI),U===s.BYTE&&($=s.RG8I),U===s.SHORT&&($=s.RG16I),U===s.INT&&($=s.RG32I)),y===s.RGB_INTEGER&&(U===s.UNSIGNED_BYTE&&($=s.RGB8UI),U===s.UNSIGNED_SHORT&&($=s.RGB16UI),U===s.UNSIGNED_INT&&($=s.RGB32UI),U===s.BYTE&&($=s.RGB8I),U===s.SHORT&&($=s.RGB16I),U===s.INT&&($=s.RGB32I)),y===s.RGBA_INTEGER&&(U===s.UNSIGNED_BYTE&&($=s.RGBA8UI),U===s.UNSIGNED_SHORT&&($=s.RGBA16UI),U===s.UNSIGNED_INT&&($=s.RGBA32UI),U===s.BYTE&&($=s.RGBA8I),U===s.SHORT&&($=s.RGBA16I),U===s.INT&&($=s.RGBA32I)),y===s.RGB&&(U===s.UNSIGNED_SHORT&&ht&&($=ht.RGB16_EXT),U===s.SHORT&&ht&&($=ht.RGB16_SNORM_EXT),U===s.UNSIGNED_INT_5_9_9_9_REV&&($=s.RGB9_E5),U===s.UNSIGNED_INT_10F_11F_11F_REV&&($=s.R11F_G11F_B10F)),y===s.RGBA){let Z=rt?Qs:$t.getTransfer(j);U===s.FLOAT&&($=s.RGBA32F),U===s.HALF_FLOAT&&($=s.RGBA16F),U===s.UNSIGNED_BYTE&&($=Z===se?s.SRGB8_ALPHA8:s.RGBA8),U===s.UNSIGNED_SHORT&&ht&&($=ht.RGBA16_EXT),U===s.SHORT&&ht&&($=ht.RGBA16_SNORM_EXT),U===s.UNSIGNED_SHORT_4_4_4_4&&($=s.RGBA4),U===s.UNSIGNED_SHORT_5_5_5_1&&($=s.RGB5_A1)}return($===s.R16F||$===s.R32F||$===s.RG16F||$===s.RG32F||$===s.RGBA16F||$===s.RGBA32F)&&t.get("EXT_color_buffer_float"),$}function _(w,y){let U;return w?y===null||y===Ri||y===Yn?U=s.DEPTH24_STENCIL8:y===yi?U=s.DEPTH32F_STENCIL8:y===Ps&&(U=s.DEPTH24_STENCIL8,It("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Ri||y===Yn?U=s.DEPTH_COMPONENT24:y===yi?U=s.DEPTH_COMPONENT32F:y===Ps&&(U=s.DEPTH_COMPONENT16),U}function M(w,y){return C(w)===!0||w.isFramebufferTexture&&w.minFilter!==Le&&w.minFilter!==Ze?Math.log2(Math.max(y.width,y.height))+1:w.mipmaps.length>0?w.mipmaps.length:w.isCompressedTexture&&Array.isArray(w.image)?y.mipmaps.length:1}function F(w){let y=new WeakRef(w);i.get(w).__ref=y,g.add(y),x.register(w,y,y)}function P(w){let y=i.get(w).__ref;y!==void 0&&(g.delete(y),x.unregister(y))}function L(w){z(w.target)}function B(w){T(w.target)}function z(w){w.removeEventListener("dispose",L),P(w),W(w),w.isVideoTexture&&h.delete(w),w.isHTMLTexture&&u.delete(w)}function T(w){w.removeEventListener("dispose",B),P(w),Q(w)}function V(){for(let w of g){let y=w.deref();y!==void 0&&(y.isRenderTarget===!0?T(y):z(y))}g.clear(),u.clear()}function W(w){let y=i.get(w);if(y.__webglInit===void 0)return;let U=w.source,it=f.get(U);if(it){let j=it[y.__cacheKey];j.usedTimes--,j.usedTimes===0&&G(w),Object.keys(it).length===0&&f.delete(U)}i.remove(w)}function G(w){let y=i.get(w);s.deleteTexture(y.__webglTexture);let U=w.source,it=f.get(U);delete it[y.__cacheKey],o.memory.textures--}function Q(w){let y=i.get(w);y.__depthDisposeCallback&&y.__depthDisposeCallback();let U=w.depthTexture;if(U&&U.renderTarget===w&&z(U),w.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(y.__webglFramebuffer[j]))for(let rt=0;rt<y.__webglFramebuffer[j].length;rt++)s.deleteFramebuffer(y.__webglFramebuffer[j][rt]);else s.deleteFramebuffer(y.__webglFramebuffer[j]);y.__webglDepthbuffer&&s.deleteRenderbuffer(y.__webglDepthbuffer[j])}else{if(Array.isArray(y.__webglFramebuffer))for(let j=0;j<y.__webglFramebuffer.length;j++)s.deleteFramebuffer(y.__webglFramebuffer[j]);else s.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&s.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&s.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let j=0;j<y.__webglColorRenderbuffer.length;j++)y.__webglColorRenderbuffer[j]&&s.deleteRenderbuffer(y.__webglColorRenderbuffer[j]);y.__webglDepthRenderbuffer&&s.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let it=w.textures;for(let j=0,rt=it.length;j<rt;j++){let ht=i.get(it[j]);ht.__webglTexture&&(s.deleteTexture(ht.__webglTexture),o.memory.textures--),i.remove(it[j])}i.remove(w)}let X=0;function J(){X=0}function tt(){return X}function yt(w){X=w}function Tt(){let w=X;return w>=n.maxTextures&&It("WebGLTextures: Trying to use "+(w+1)+" texture units while this GPU supports only "+n.maxTextures),X+=1,w}function Y(w){let y=[];return y.push(w.wrapS),y.push(w.wrapT),y.push(w.wrapR||0),y.push(w.magFilter),y.push(w.minFilter),y.push(w.anisotropy),y.push(w.internalFormat),y.push(w.format),y.push(w.type),y.push(w.generateMipmaps),y.push(w.mipmapsAutoUpdate),y.push(w.premultiplyAlpha),y.push(w.flipY),y.push(w.unpackAlignment),y.push(w.colorSpace),y.join()}function dt(w,y){let U=i.get(w);if(w.isVideoTexture&&we(w),w.isRenderTargetTexture===!1&&w.isExternalTexture!==!0&&w.version>0&&U.__version!==w.version){let it=w.image;if(it===null)It("WebGLRenderer: Texture marked for update but no image data found.");else if(it.complete===!1)It("WebGLRenderer: Texture marked for update but image is incomplete");else{be(U,w,y);return}}else w.isExternalTexture&&(U.__webglTexture=w.sourceTexture?w.sourceTexture:null);e.bindTexture(s.TEXTURE_2D,U.__webglTexture,s.TEXTURE0+y)}function et(w,y){let U=i.get(w);if(w.isRenderTargetTexture===!1&&w.version>0&&U.__version!==w.version){be(U,w,y);return}else w.isExternalTexture&&(U.__webglTexture=w.sourceTexture?w.sourceTexture:null);e.bindTexture(s.TEXTURE_2D_ARRAY,U.__webglTexture,s.TEXTURE0+y)}function xt(w,y){let U=i.get(w);if(w.isRenderTargetTexture===!1&&w.version>0&&U.__version!==w.version){be(U,w,y);return}e.bindTexture(s.TEXTURE_3D,U.__webglTexture,s.TEXTURE0+y)}function ft(w,y){let U=i.get(w);if(w.version>0&&U.__version!==w.version){ti(U,w,y);return}e.bindTexture(s.TEXTURE_CUBE_MAP,U.__webglTexture,s.TEXTURE0+y)}let Nt={[Uo]:s.REPEAT,[Fi]:s.CLAMP_TO_EDGE,[ko]:s.MIRRORED_REPEAT},ge={[Le]:s.NEAREST,[od]:s.NEAREST_MIPMAP_NEAREST,[wr]:s.NEAREST_MIPMAP_LINEAR,[Ze]:s.LINEAR,[ua]:s.LINEAR_MIPMAP_NEAREST,[en]:s.LINEAR_MIPMAP_LINEAR},Pt={[hd]:s.NEVER,[Wl]:s.ALWAYS,[ud]:s.LESS,[Vl]:s.LEQUAL,[dd]:s.EQUAL,[Hl]:s.GEQUAL,[fd]:s.GREATER,[pd]:s.NOTEQUAL};function jt(w,y){if(y.type===yi&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===Ze||y.magFilter===ua||y.magFilter===wr||y.magFilter===en||y.minFilter===Ze||y.minFilter===ua||y.minFilter===wr||y.minFilter===en)&&It("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),s.texParameteri(w,s.TEXTURE_WRAP_S,Nt[y.wrapS]),s.texParameteri(w,s.TEXTURE_WRAP_T,Nt[y.wrapT]),(w===s.TEXTURE_3D||w===s.TEXTURE_2D_ARRAY)&&s.texParameteri(w,s.TEXTURE_WRAP_R,Nt[y.wrapR]),s.texParameteri(w,s.TEXTURE_MAG_FILTER,ge[y.magFilter]),s.texParameteri(w,s.TEXTURE_MIN_FILTER,ge[y.minFilter]),y.compareFunction&&(s.texParameteri(w,s.TEXTURE_COMPARE_MODE,s.COMPARE_REF_TO_TEXTURE),s.texParameteri(w,s.TEXTURE_COMPARE_FUNC,Pt[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Le||y.minFilter!==wr&&y.minFilter!==en||y.type===yi&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let U=t.get("EXT_texture_filter_anisotropic");s.texParameterf(w,U.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,n.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function ne(w,y){let U=!1;w.__webglInit===void 0&&(w.__webglInit=!0,y.addEventListener("dispose",L),F(y));let it=y.source,j=f.get(it);j===void 0&&(j={},f.set(it,j));let rt=Y(y);if(rt!==w.__cacheKey){j[rt]===void 0&&(j[rt]={texture:s.createTexture(),usedTimes:0},o.memory.textures++,U=!0),j[rt].usedTimes++;let ht=j[w.__cacheKey];ht!==void 0&&(j[w.__cacheKey].usedTimes--,ht.usedTimes===0&&G(y)),w.__cacheKey=rt,w.__webglTexture=j[rt].texture}return U}function Ut(w,y,U){return Math.floor(Math.floor(w/U)/y)}function Qt(w,y,U,it){let rt=w.updateRanges;if(rt.length===0)e.texSubImage2D(s.TEXTURE_2D,0,0,0,y.width,y.height,U,it,y.data);else{rt.sort((R,K)=>R.start-K.start);let ht=0;for(let R=1;R<rt.length;R++){let K=rt[ht],q=rt[R],ct=K.start+K.count,st=Ut(q.start,y.width,4),ot=Ut(K.start,y.width,4);q.start<=ct+1&&st===ot&&Ut(q.start+q.count-1,y.width,4)===st?K.count=Math.max(K.count,q.start+q.count-K.start):(++ht,rt[ht]=q)}rt.length=ht+1;let $=e.getParameter(s.UNPACK_ROW_LENGTH),Z=e.getParameter(s.UNPACK_SKIP_PIXELS),at=e.getParameter(s.UNPACK_SKIP_ROWS);e.pixelStorei(s.UNPACK_ROW_LENGTH,y.width);for(let R=0,K=rt.length;R<K;R++){let q=rt[R],ct=Math.floor(q.start/4),st=Math.ceil(q.count/4),ot=ct%y.width,wt=Math.floor(ct/y.width),zt=st,nt=1;e.pixelStorei(s.UNPACK_SKIP_PIXELS,ot),e.pixelStorei(s.UNPACK_SKIP_ROWS,wt),e.texSubImage2D(s.TEXTURE_2D,0,ot,wt,zt,nt,U,it,y.data)}w.clearUpdateRanges(),e.pixelStorei(s.UNPACK_ROW_LENGTH,$),e.pixelStorei(s.UNPACK_SKIP_PIXELS,Z),e.pixelStorei(s.UNPACK_SKIP_ROWS,at)}}function be(w,y,U){let it=s.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(it=s.TEXTURE_2D_ARRAY),y.isData3DTexture&&(it=s.TEXTURE_3D);let j=ne(w,y),rt=y.source;e.bindTexture(it,w.__webglTexture,s.TEXTURE0+U);let ht=i.get(rt);if(rt.version!==ht.__version||j===!0){if(e.activeTexture(s.TEXTURE0+U),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let nt=$t.getPrimaries($t.workingColorSpace),Ct=y.colorSpace===sn?null:$t.getPrimaries(y.colorSpace),kt=y.colorSpace===sn||nt===Ct?s.NONE:s.BROWSER_DEFAULT_WEBGL;e.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,y.flipY),e.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),e.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,kt)}e.pixelStorei(s.UNPACK_ALIGNMENT,y.unpackAlignment);let Z=S(y.image,!1,n.maxTextureSize);Z=Dt(y,Z);let at=r.convert(y.format,y.colorSpace),R=r.convert(y.type),K=E(y.internalFormat,at,R,y.normalized,y.colorSpace,y.isVideoTexture);jt(it,y);let q,ct=y.mipmaps,st=y.isVideoTexture!==!0,ot=ht.__version===void 0||j===!0,wt=rt.dataReady,zt=M(y,Z);if(y.isDepthTexture)K=_(y.format===nn,y.type),ot&&(st?e.texStorage2D(s.TEXTURE_2D,1,K,Z.width,Z.height):e.texImage2D(s.TEXTURE_2D,0,K,Z.width,Z.height,0,at,R,null));else if(y.isDataTexture)if(ct.length>0){st&&ot&&e.texStorage2D(s.TEXTURE_2D,zt,K,ct[0].width,ct[0].height);for(let nt=0,Ct=ct.length;nt<Ct;nt++)q=ct[nt],st?wt&&e.texSubImage2D(s.TEXTURE_2D,nt,0,0,q.width,q.height,at,R,q.data):e.texImage2D(s.TEXTURE_2D,nt,K,q.width,q.height,0,at,R,q.data);y.generateMipmaps=!1}else st?(ot&&e.texStorage2D(s.TEXTURE_2D,zt,K,Z.width,Z.height),wt&&Qt(y,Z,at,R)):e.texImage2D(s.TEXTURE_2D,0,K,Z.width,Z.height,0,at,R,Z.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){st&&ot&&e.texStorage3D(s.TEXTURE_2D_ARRAY,zt,K,ct[0].width,ct[0].height,Z.depth);for(let nt=0,Ct=ct.length;nt<Ct;nt++)if(q=ct[nt],y.format!==Ii)if(at!==null)if(st){if(wt)if(y.layerUpdates.size>0){let kt=Ql(q.width,q.height,y.format,y.type);for(let mt of y.layerUpdates){let ce=q.data.subarray(mt*kt/q.data.BYTES_PER_ELEMENT,(mt+1)*kt/q.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(s.TEXTURE_2D_ARRAY,nt,0,0,mt,q.width,q.height,1,at,ce)}}else e.compressedTexSubImage3D(s.TEXTURE_2D_ARRAY,nt,0,0,0,q.width,q.height,Z.depth,at,q.data)}else e.compressedTexImage3D(s.TEXTURE_2D_ARRAY,nt,K,q.width,q.height,Z.depth,0,q.data,0,0);else It("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else st?wt&&e.texSubImage3D(s.TEXTURE_2D_ARRAY,nt,0,0,0,q.width,q.height,Z.depth,at,R,q.data):e.texImage3D(s.TEXTURE_2D_ARRAY,nt,K,q.width,q.height,Z.depth,0,at,R,q.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{st&&ot&&e.texStorage2D(s.TEXTURE_2D,zt,K,ct[0].width,ct[0].height);for(let nt=0,Ct=ct.length;nt<Ct;nt++)q=ct[nt],y.format!==Ii?at!==null?st?wt&&e.compressedTexSubImage2D(s.TEXTURE_2D,nt,0,0,q.width,q.height,at,q.data):e.compressedTexImage2D(s.TEXTURE_2D,nt,K,q.width,q.height,0,q.data):It("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):st?wt&&e.texSubImage2D(s.TEXTURE_2D,nt,0,0,q.width,q.height,at,R,q.data):e.texImage2D(s.TEXTURE_2D,nt,K,q.width,q.height,0,at,R,q.data)}else if(y.isDataArrayTexture)if(st){if(ot&&e.texStorage3D(s.TEXTURE_2D_ARRAY,zt,K,Z.width,Z.height,Z.depth),wt)if(y.layerUpdates.size>0){let nt=Ql(Z.width,Z.height,y.format,y.type);for(let Ct of y.layerUpdates){let kt=Z.data.subarray(Ct*nt/Z.data.BYTES_PER_ELEMENT,(Ct+1)*nt/Z.data.BYTES_PER_ELEMENT);e.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,Ct,Z.width,Z.height,1,at,R,kt)}y.clearLayerUpdates()}else e.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,at,R,Z.data)}else e.texImage3D(s.TEXTURE_2D_ARRAY,0,K,Z.width,Z.height,Z.depth,0,at,R,Z.data);else if(y.isData3DTexture)st?(ot&&e.texStorage3D(s.TEXTURE_3D,zt,K,Z.width,Z.height,Z.depth),wt&&e.texSubImage3D(s.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,at,R,Z.data)):e.texImage3D(s.TEXTURE_3D,0,K,Z.width,Z.height,Z.depth,0,at,R,Z.data);else if(y.isFramebufferTexture){if(ot)if(st)e.texStorage2D(s.TEXTURE_2D,zt,K,Z.width,Z.height);else{let nt=Z.width,Ct=Z.height;for(let kt=0;kt<zt;kt++)e.texImage2D(s.TEXTURE_2D,kt,K,nt,Ct,0,at,R,null),nt>>=1,Ct>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in s){let nt=s.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),Z.parentNode!==nt){nt.appendChild(Z),u.add(y),nt.onpaint=Ct=>{let kt=Ct.changedElements;for(let mt of u)kt.includes(mt.image)&&(mt.needsUpdate=!0)},nt.requestPaint();return}if(s.texElementImage2D.length===3)s.texElementImage2D(s.TEXTURE_2D,s.RGBA8,Z);else{let kt=s.RGBA,mt=s.RGBA,ce=s.UNSIGNED_BYTE;s.texElementImage2D(s.TEXTURE_2D,0,kt,mt,ce,Z)}s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MIN_FILTER,s.LINEAR),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_WRAP_S,s.CLAMP_TO_EDGE),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_WRAP_T,s.CLAMP_TO_EDGE)}}else if(ct.length>0){if(st&&ot){let nt=Bt(ct[0]);e.texStorage2D(s.TEXTURE_2D,zt,K,nt.width,nt.height)}for(let nt=0,Ct=ct.length;nt<Ct;nt++)q=ct[nt],st?wt&&e.texSubImage2D(s.TEXTURE_2D,nt,0,0,at,R,q):e.texImage2D(s.TEXTURE_2D,nt,K,at,R,q);y.generateMipmaps=!1}else if(st){if(ot){let nt=Bt(Z);e.texStorage2D(s.TEXTURE_2D,zt,K,nt.width,nt.height)}wt&&e.texSubImage2D(s.TEXTURE_2D,0,0,0,at,R,Z)}else e.texImage2D(s.TEXTURE_2D,0,K,at,R,Z);C(y)&&y.mipmapsAutoUpdate===!0&&b(it),ht.__version=rt.version,y.onUpdate&&y.onUpdate(y)}w.__version=y.version}function ti(w,y,U){if(y.image.length!==6)return;let it=ne(w,y),j=y.source;e.bindTexture(s.TEXTURE_CUBE_MAP,w.__webglTexture,s.TEXTURE0+U);let rt=i.get(j);if(j.version!==rt.__version||it===!0){e.activeTexture(s.TEXTURE0+U);let ht=$t.getPrimaries($t.workingColorSpace),$=y.colorSpace===sn?null:$t.getPrimaries(y.colorSpace),Z=y.colorSpace===sn||ht===$?s.NONE:s.BROWSER_DEFAULT_WEBGL;e.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,y.flipY),e.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),e.pixelStorei(s.UNPACK_ALIGNMENT,y.unpackAlignment),e.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let at=y.isCompressedTexture||y.image[0].isCompressedTexture,R=y.image[0]&&y.image[0].isDataTexture,K=[];for(let mt=0;mt<6;mt++)!at&&!R?K[mt]=S(y.image[mt],!0,n.maxCubemapSize):K[mt]=R?y.image[mt].image:y.image[mt],K[mt]=Dt(y,K[mt]);let q=K[0],ct=r.convert(y.format,y.colorSpace),st=r.convert(y.type),ot=E(y.internalFormat,ct,st,y.normalized,y.colorSpace),wt=y.isVideoTexture!==!0,zt=rt.__version===void 0||it===!0,nt=j.dataReady,Ct=M(y,q);jt(s.TEXTURE_CUBE_MAP,y);let kt;if(y.isDepthTexture){if(ot=_(y.format===nn,y.type),zt)if(wt)e.texStorage2D(s.TEXTURE_CUBE_MAP,1,ot,q.width,q.height);else for(let mt=0;mt<6;mt++)e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,ot,q.width,q.height,0,ct,st,null)}else if(at){wt&&zt&&e.texStorage2D(s.TEXTURE_CUBE_MAP,Ct,ot,q.width,q.height);for(let mt=0;mt<6;mt++){kt=K[mt].mipmaps;for(let ce=0;ce<kt.length;ce++){let Re=kt[ce];y.format!==Ii?ct!==null?wt?nt&&e.compressedTexSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ce,0,0,Re.width,Re.height,ct,Re.data):e.compressedTexImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ce,ot,Re.width,Re.height,0,Re.data):It("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):wt?nt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ce,0,0,Re.width,Re.height,ct,st,Re.data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ce,ot,Re.width,Re.height,0,ct,st,Re.data)}}}else{if(kt=y.mipmaps,wt&&zt){kt.length>0&&Ct++;let mt=Bt(K[0]);e.texStorage2D(s.TEXTURE_CUBE_MAP,Ct,ot,mt.width,mt.height)}for(let mt=0;mt<6;mt++)if(R){wt?nt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,0,0,K[mt].width,K[mt].height,ct,st,K[mt].data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,ot,K[mt].width,K[mt].height,0,ct,st,K[mt].data);for(let ce=0;ce<kt.length;ce++){let hn=kt[ce].image[mt].image;wt?nt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ce+1,0,0,hn.width,hn.height,ct,st,hn.data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ce+1,ot,hn.width,hn.height,0,ct,st,hn.data)}}else{wt?nt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,0,0,ct,st,K[mt]):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,ot,ct,st,K[mt]);for(let ce=0;ce<kt.length;ce++){let Re=kt[ce];wt?nt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ce+1,0,0,ct,st,Re.image[mt]):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ce+1,ot,ct,st,Re.image[mt])}}}C(y)&&y.mipmapsAutoUpdate===!0&&b(s.TEXTURE_CUBE_MAP),rt.__version=j.version,y.onUpdate&&y.onUpdate(y)}w.__version=y.version}function _e(w,y,U,it,j,rt){let ht=r.convert(U.format,U.colorSpace),$=r.convert(U.type),Z=E(U.internalFormat,ht,$,U.normalized,U.colorSpace),at=i.get(y),R=i.get(U);if(R.__renderTarget=y,!at.__hasExternalTextures){let K=Math.max(1,y.width>>rt),q=Math.max(1,y.height>>rt);j===s.TEXTURE_3D||j===s.TEXTURE_2D_ARRAY?e.texImage3D(j,rt,Z,K,q,y.depth,0,ht,$,null):e.texImage2D(j,rt,Z,K,q,0,ht,$,null)}e.bindFramebuffer(s.FRAMEBUFFER,w),pt(y)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,it,j,R.__webglTexture,0,pe(y)):(j===s.TEXTURE_2D||j>=s.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=s.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&s.framebufferTexture2D(s.FRAMEBUFFER,it,j,R.__webglTexture,rt),e.bindFramebuffer(s.FRAMEBUFFER,null)}function Di(w,y,U){if(s.bindRenderbuffer(s.RENDERBUFFER,w),y.depthBuffer){let it=y.depthTexture,j=it&&it.isDepthTexture?it.type:null,rt=_(y.stencilBuffer,j),ht=y.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;pt(y)?a.renderbufferStorageMultisampleEXT(s.RENDERBUFFER,pe(y),rt,y.width,y.height):U?s.renderbufferStorageMultisample(s.RENDERBUFFER,pe(y),rt,y.width,y.height):s.renderbufferStorage(s.RENDERBUFFER,rt,y.width,y.height),s.framebufferRenderbuffer(s.FRAMEBUFFER,ht,s.RENDERBUFFER,w)}else{let it=y.textures;for(let j=0;j<it.length;j++){let rt=it[j],ht=r.convert(rt.format,rt.colorSpace),$=r.convert(rt.type),Z=E(rt.internalFormat,ht,$,rt.normalized,rt.colorSpace);pt(y)?a.renderbufferStorageMultisampleEXT(s.RENDERBUFFER,pe(y),Z,y.width,y.height):U?s.renderbufferStorageMultisample(s.RENDERBUFFER,pe(y),Z,y.width,y.height):s.renderbufferStorage(s.RENDERBUFFER,Z,y.width,y.height)}}s.bindRenderbuffer(s.RENDERBUFFER,null)}function Ce(w,y,U){let it=y.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(s.FRAMEBUFFER,w),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=i.get(y.depthTexture);j.__renderTarget=y;let rt=it?y.depthTexture.image[0]:y.depthTexture.image;(!j.__webglTexture||rt.width!==y.width||rt.height!==y.height)&&(rt.width=y.width,rt.height=y.height,y.depthTexture.needsUpdate=!0),it?ft(y.depthTexture,0):dt(y.depthTexture,0);let ht=j.__webglTexture,$=pe(y),Z=it?s.TEXTURE_CUBE_MAP_POSITIVE_X+U:s.TEXTURE_2D,at=y.depthTexture.format===nn?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;if(y.depthTexture.format===Ki)pt(y)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,at,Z,ht,0,$):s.framebufferTexture2D(s.FRAMEBUFFER,at,Z,ht,0);else if(y.depthTexture.format===nn)pt(y)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,at,Z,ht,0,$):s.framebufferTexture2D(s.FRAMEBUFFER,at,Z,ht,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function ui(w){let y=i.get(w),U=w.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==w.depthTexture){let it=w.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),it){let j=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,it.removeEventListener("dispose",j)};it.addEventListener("dispose",j),y.__depthDisposeCallback=j}y.__boundDepthTexture=it}if(w.depthTexture&&!y.__autoAllocateDepthBuffer)if(U)for(let it=0;it<6;it++)Ce(y.__webglFramebuffer[it],w,it);else w.texture.mipmaps.length>0?Ce(y.__webglFramebuffer[0],w,0):Ce(y.__webglFramebuffer,w,0);else if(U){y.__webglDepthbuffer=[];for(let it=0;it<6;it++)if(e.bindFramebuffer(s.FRAMEBUFFER,y.__webglFramebuffer[it]),y.__webglDepthbuffer[it]===void 0)y.__webglDepthbuffer[it]=s.createRenderbuffer(),Di(y.__webglDepthbuffer[it],w,!1);else{let j=w.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,rt=y.__webglDepthbuffer[it];s.bindRenderbuffer(s.RENDERBUFFER,rt),s.framebufferRenderbuffer(s.FRAMEBUFFER,j,s.RENDERBUFFER,rt)}}else if(w.texture.mipmaps.length>0?e.bindFramebuffer(s.FRAMEBUFFER,y.__webglFramebuffer[0]):e.bindFramebuffer(s.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=s.createRenderbuffer(),Di(y.__webglDepthbuffer,w,!1);else{let j=w.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,rt=y.__webglDepthbuffer;s.bindRenderbuffer(s.RENDERBUFFER,rt),s.framebufferRenderbuffer(s.FRAMEBUFFER,j,s.RENDERBUFFER,rt)}e.bindFramebuffer(s.FRAMEBUFFER,null)}function di(w,y,U){let it=i.get(w);y!==void 0&&_e(it.__webglFramebuffer,w,w.texture,s.COLOR_ATTACHMENT0,s.TEXTURE_2D,0),U!==void 0&&ui(w)}function fi(w){let y=w.texture,U=i.get(w),it=i.get(y);w.addEventListener("dispose",B),F(w);let j=w.textures,rt=w.isWebGLCubeRenderTarget===!0,ht=j.length>1;if(ht||(it.__webglTexture===void 0&&(it.__webglTexture=s.createTexture()),it.__version=y.version,o.memory.textures++),rt){U.__webglFramebuffer=[];for(let $=0;$<6;$++)if(y.mipmaps.length>0){U.__webglFramebuffer[$]=[];for(let Z=0;Z<y.mipmaps.length;Z++)U.__webglFramebuffer[$][Z]=s.createFramebuffer()}else U.__webglFramebuffer[$]=s.createFramebuffer()}else{if(y.mipmaps.length>0){U.__webglFramebuffer=[];for(let $=0;$<y.mipmaps.length;$++)U.__webglFramebuffer[$]=s.createFramebuffer()}else U.__webglFramebuffer=s.createFramebuffer();if(ht)for(let $=0,Z=j.length;$<Z;$++){let at=i.get(j[$]);at.__webglTexture===void 0&&(at.__webglTexture=s.createTexture(),o.memory.textures++)}if(w.samples>0&&pt(w)===!1){U.__webglMultisampledFramebuffer=s.createFramebuffer(),U.__webglColorRenderbuffer=[],e.bindFramebuffer(s.FRAMEBUFFER,U.__webglMultisampledFramebuffer);for(let $=0;$<j.length;$++){let Z=j[$];U.__webglColorRenderbuffer[$]=s.createRenderbuffer(),s.bindRenderbuffer(s.RENDERBUFFER,U.__webglColorRenderbuffer[$]);let at=r.convert(Z.format,Z.colorSpace),R=r.convert(Z.type),K=E(Z.internalFormat,at,R,Z.normalized,Z.colorSpace,w.isXRRenderTarget===!0),q=pe(w);s.renderbufferStorageMultisample(s.RENDERBUFFER,q,K,w.width,w.height),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+$,s.RENDERBUFFER,U.__webglColorRenderbuffer[$])}s.bindRenderbuffer(s.RENDERBUFFER,null),w.depthBuffer&&(U.__webglDepthRenderbuffer=s.createRenderbuffer(),Di(U.__webglDepthRenderbuffer,w,!0)),e.bindFramebuffer(s.FRAMEBUFFER,null)}}if(rt){e.bindTexture(s.TEXTURE_CUBE_MAP,it.__webglTexture),jt(s.TEXTURE_CUBE_MAP,y);for(let $=0;$<6;$++)if(y.mipmaps.length>0)for(let Z=0;Z<y.mipmaps.length;Z++)_e(U.__webglFramebuffer[$][Z],w,y,s.COLOR_ATTACHMENT0,s.TEXTURE_CUBE_MAP_POSITIVE_X+$,Z);else _e(U.__webglFramebuffer[$],w,y,s.COLOR_ATTACHMENT0,s.TEXTURE_CUBE_MAP_POSITIVE_X+$,0);C(y)?b(s.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&s.texParameteri(s.TEXTURE_CUBE_MAP,s.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),e.unbindTexture()}else if(ht){for(let $=0,Z=j.length;$<Z;$++){let at=j[$],R=i.get(at),K=s.TEXTURE_2D;(w.isWebGL3DRenderTarget||w.isWebGLArrayRenderTarget)&&(K=w.isWebGL3DRenderTarget?s.TEXTURE_3D:s.TEXTURE_2D_ARRAY),e.bindTexture(K,R.__webglTexture),jt(K,at),_e(U.__webglFramebuffer,w,at,s.COLOR_ATTACHMENT0+$,K,0),C(at)&&b(K)}e.unbindTexture()}else{let $=s.TEXTURE_2D;if((w.isWebGL3DRenderTarget||w.isWebGLArrayRenderTarget)&&($=w.isWebGL3DRenderTarget?s.TEXTURE_3D:s.TEXTURE_2D_ARRAY),e.bindTexture($,it.__webglTexture),jt($,y),y.mipmaps.length>0)for(let Z=0;Z<y.mipmaps.length;Z++)_e(U.__webglFramebuffer[Z],w,y,s.COLOR_ATTACHMENT0,$,Z);else _e(U.__webglFramebuffer,w,y,s.COLOR_ATTACHMENT0,$,0);C(y)?b($):y.mipmaps.length>0&&s.texParameteri($,s.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),e.unbindTexture()}w.depthBuffer&&ui(w)}function N(w){let y=w.textures;for(let U=0,it=y.length;U<it;U++){let j=y[U];if(C(j)&&j.mipmapsAutoUpdate===!0){let rt=A(w),ht=i.get(j).__webglTexture;e.bindTexture(rt,ht),b(rt),e.unbindTexture()}}}let pi=[];function fe(w){if(w.samples>0){if(pt(w)===!1){let y=w.textures,U=w.width,it=w.height,j=s.COLOR_BUFFER_BIT,rt=w.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,ht=i.get(w),$=y.length>1;if($)for(let at=0;at<y.length;at++)e.bindFramebuffer(s.FRAMEBUFFER,ht.__webglMultisampledFramebuffer),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+at,s.RENDERBUFFER,null),e.bindFramebuffer(s.FRAMEBUFFER,ht.__webglFramebuffer),s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0+at,s.TEXTURE_2D,null,0);e.bindFramebuffer(s.READ_FRAMEBUFFER,ht.__webglMultisampledFramebuffer),w.texture.mipmaps.length>0?e.bindFramebuffer(s.DRAW_FRAMEBUFFER,ht.__webglFramebuffer[0]):e.bindFramebuffer(s.DRAW_FRAMEBUFFER,ht.__webglFramebuffer);for(let at=0;at<y.length;at++){if(w.resolveDepthBuffer&&(w.depthBuffer&&(j|=s.DEPTH_BUFFER_BIT),w.stencilBuffer&&w.resolveStencilBuffer&&(j|=s.STENCIL_BUFFER_BIT)),$){s.framebufferRenderbuffer(s.READ_FRAMEBUFFER,s.COLOR_ATTACHMENT0,s.RENDERBUFFER,ht.__webglColorRenderbuffer[at]);let R=i.get(y[at]).__webglTexture;s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0,s.TEXTURE_2D,R,0)}s.blitFramebuffer(0,0,U,it,0,0,U,it,j,s.NEAREST),c===!0&&(pi.length=0,pi.push(s.COLOR_ATTACHMENT0+at),w.depthBuffer&&w.storeMultisampledDepthBuffer===!1&&pi.push(rt),s.invalidateFramebuffer(s.READ_FRAMEBUFFER,pi))}if(e.bindFramebuffer(s.READ_FRAMEBUFFER,null),e.bindFramebuffer(s.DRAW_FRAMEBUFFER,null),$)for(let at=0;at<y.length;at++){e.bindFramebuffer(s.FRAMEBUFFER,ht.__webglMultisampledFramebuffer),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+at,s.RENDERBUFFER,ht.__webglColorRenderbuffer[at]);let R=i.get(y[at]).__webglTexture;e.bindFramebuffer(s.FRAMEBUFFER,ht.__webglFramebuffer),s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0+at,s.TEXTURE_2D,R,0)}e.bindFramebuffer(s.DRAW_FRAMEBUFFER,ht.__webglMultisampledFramebuffer)}else if(w.depthBuffer&&w.storeMultisampledDepthBuffer===!1&&c){let y=w.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;s.invalidateFramebuffer(s.DRAW_FRAMEBUFFER,[y])}}}function pe(w){return Math.min(n.maxSamples,w.samples)}function pt(w){let y=i.get(w);return w.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function we(w){let y=o.render.frame;h.get(w)!==y&&(h.set(w,y),w.update())}function Dt(w,y){let U=w.colorSpace,it=w.format,j=w.type;return w.isCompressedTexture===!0||w.isVideoTexture===!0||U!==Un&&U!==sn&&($t.getTransfer(U)===se?(it!==Ii||j!==ei)&&It("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Lt("WebGLTextures: Unsupported texture color space:",U)),y}function Bt(w){return typeof HTMLImageElement<"u"&&w instanceof HTMLImageElement?(l.width=w.naturalWidth||w.width,l.height=w.naturalHeight||w.height):typeof VideoFrame<"u"&&w instanceof VideoFrame?(l.width=w.displayWidth,l.height=w.displayHeight):(l.width=w.width,l.height=w.height),l}this.allocateTextureUnit=Tt,this.resetTextureUnits=J,this.getTextureUnits=tt,this.setTextureUnits=yt,this.setTexture2D=dt,this.setTexture2DArray=et,this.setTexture3D=xt,this.setTextureCube=ft,this.rebindTextures=di,this.setupRenderTarget=fi,this.updateRenderTargetMipmap=N,this.updateMultisampleRenderTarget=fe,this.setupDepthRenderbuffer=ui,this.setupFrameBufferTexture=_e,this.useMultisampledRTT=pt,this.dispose=V}function Kx(s,t){function e(i,n=sn){let r,o=$t.getTransfer(n);if(i===ei)return s.UNSIGNED_BYTE;if(i===fa)return s.UNSIGNED_SHORT_4_4_4_4;if(i===pa)return s.UNSIGNED_SHORT_5_5_5_1;if(i===Ul)return s.UNSIGNED_INT_5_9_9_9_REV;if(i===kl)return s.UNSIGNED_INT_10F_11F_11F_REV;if(i===Bl)return s.BYTE;if(i===Ol)return s.SHORT;if(i===Ps)return s.UNSIGNED_SHORT;if(i===da)return s.INT;if(i===Ri)return s.UNSIGNED_INT;if(i===yi)return s.FLOAT;if(i===Pi)return s.HALF_FLOAT;if(i===zl)return s.ALPHA;if(i===Gl)return s.RGB;if(i===Ii)return s.RGBA;if(i===Ki)return s.DEPTH_COMPONENT;if(i===nn)return s.DEPTH_STENCIL;if(i===ma)return s.RED;if(i===ga)return s.RED_INTEGER;if(i===Tn)return s.RG;if(i===_a)return s.RG_INTEGER;if(i===xa)return s.RGBA_INTEGER;if(i===Er||i===Ar||i===Tr||i===Cr)if(o===se)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Er)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ar)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Tr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Cr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Er)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ar)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Tr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Cr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ya||i===va||i===Sa||i===Ma)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ya)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===va)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Sa)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ma)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===ba||i===wa||i===Ea||i===Aa||i===Ta||i===Rr||i===Ca)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===ba||i===wa)return o===se?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ea)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Aa)return r.COMPRESSED_R11_EAC;if(i===Ta)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Rr)return r.COMPRESSED_RG11_EAC;if(i===Ca)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ra||i===Pa||i===Ia||i===Da||i===La||i===Na||i===Fa||i===Ba||i===Oa||i===Ua||i===ka||i===za||i===Ga||i===Va)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ra)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Pa)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ia)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Da)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===La)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Na)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Fa)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ba)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Oa)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ua)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ka)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===za)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ga)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Va)return o===se?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ha||i===Wa||i===Xa)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Ha)return o===se?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Wa)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Xa)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===qa||i===Ya||i===Pr||i===$a)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===qa)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ya)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Pr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===$a)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Yn?s.UNSIGNED_INT_24_8:s[i]!==void 0?s[i]:null}return{convert:e}}var jx=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Qx=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,ch=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new hr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Oi({vertexShader:jx,fragmentShader:Qx,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Me(new fr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},lh=class extends Ai{constructor(t,e){super();let i=this,n=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,d=null,f=null,g=null,x=typeof XRWebGLBinding<"u",p=new ch,m={},S=e.getContextAttributes(),C=null,b=null,A=[],E=[],_=new Rt,M=null,F=null,P=new $e;P.viewport=new me;let L=new $e;L.viewport=new me;let B=[P,L],z=new aa,T=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let dt=A[Y];return dt===void 0&&(dt=new Ms,A[Y]=dt),dt.getTargetRaySpace()},this.getControllerGrip=function(Y){let dt=A[Y];return dt===void 0&&(dt=new Ms,A[Y]=dt),dt.getGripSpace()},this.getHand=function(Y){let dt=A[Y];return dt===void 0&&(dt=new Ms,A[Y]=dt),dt.getHandSpace()};function W(Y){let dt=E.indexOf(Y.inputSource);if(dt===-1)return;let et=A[dt];et!==void 0&&(et.update(Y.inputSource,Y.frame,l||o),et.dispatchEvent({type:Y.type,data:Y.inputSource}))}function G(){n.removeEventListener("select",W),n.removeEventListener("selectstart",W),n.removeEventListener("selectend",W),n.removeEventListener("squeeze",W),n.removeEventListener("squeezestart",W),n.removeEventListener("squeezeend",W),n.removeEventListener("end",G),n.removeEventListener("inputsourceschange",Q);for(let Y=0;Y<A.length;Y++){let dt=E[Y];dt!==null&&(E[Y]=null,A[Y].disconnect(dt))}T=null,V=null,p.reset();for(let Y in m)delete m[Y];if(t.setRenderTarget(C),f=null,d=null,u=null,n=null,b=null,Tt.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(_.width,_.height,!1),F!==null){let Y=F.camera;Y.fov=F.fov,Y.zoom=F.zoom,Y.updateProjectionMatrix(),F=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,i.isPresenting===!0&&It("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){a=Y,i.isPresenting===!0&&It("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(Y){l=Y},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(n,e)),u},this.getFrame=function(){return g},this.getSession=function(){return n},this.setSession=async function(Y){if(n=Y,n!==null){if(C=t.getRenderTarget(),n.addEventListener("select",W),n.addEventListener("selectstart",W),n.addEventListener("selectend",W),n.addEventListener("squeeze",W),n.addEventListener("squeezestart",W),n.addEventListener("squeezeend",W),n.addEventListener("end",G),n.addEventListener("inputsourceschange",Q),S.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let et=null,xt=null,ft=null;S.depth&&(ft=S.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,et=S.stencil?nn:Ki,xt=S.stencil?Yn:Ri);let Nt={colorFormat:e.RGBA8,depthFormat:ft,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Nt),n.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new ai(d.textureWidth,d.textureHeight,{format:Ii,type:ei,depthTexture:new tn(d.textureWidth,d.textureHeight,xt,void 0,void 0,void 0,void 0,void 0,void 0,et),stencilBuffer:S.stencil,colorSpace:t.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let et={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(n,e,et),n.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new ai(f.framebufferWidth,f.framebufferHeight,{format:Ii,type:ei,colorSpace:t.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await n.requestReferenceSpace(a),Tt.setContext(n),Tt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(n!==null)return n.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function Q(Y){for(let dt=0;dt<Y.removed.length;dt++){let et=Y.removed[dt],xt=E.indexOf(et);xt>=0&&(E[xt]=null,A[xt].disconnect(et))}for(let dt=0;dt<Y.added.length;dt++){let et=Y.added[dt],xt=E.indexOf(et);if(xt===-1){for(let Nt=0;Nt<A.length;Nt++)if(Nt>=E.length){E.push(et),xt=Nt;break}else if(E[Nt]===null){E[Nt]=et,xt=Nt;break}if(xt===-1)break}let ft=A[xt];ft&&ft.connect(et)}}function X(Y,dt){dt===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(dt.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(n===null)return;let dt=Y.near,et=Y.far;p.texture!==null&&(p.depthNear>0&&(dt=p.depthNear),p.depthFar>0&&(et=p.depthFar)),z.near=L.near=P.near=dt,z.far=L.far=P.far=et,(T!==z.near||V!==z.far)&&(n.updateRenderState({depthNear:z.near,depthFar:z.far}),T=z.near,V=z.far),z.layers.mask=Y.layers.mask|6,P.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let xt=Y.parent,ft=z.cameras;X(z,xt);for(let Nt=0;Nt<ft.length;Nt++)X(ft[Nt],xt);z.projectionMatrix.copy(P.projectionMatrix),z.projectionMatrixInverse.copy(P.projectionMatrixInverse),F===null&&Y.isPerspectiveCamera&&(F={camera:Y,fov:Y.fov,zoom:Y.zoom}),J(Y,z,xt)};function J(Y,dt,et){et===null?Y.matrix.copy(dt.matrixWorld):(Y.matrix.copy(et.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(dt.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(dt.projectionMatrix),Y.projectionMatrixInverse.copy(dt.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=ys*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(Y){c=Y,d!==null&&(d.fixedFoveation=Y),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Y)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(z)},this.getCameraTexture=function(Y){return m[Y]};let tt=null;function yt(Y,dt){if(h=dt.getViewerPose(l||o),g=dt,h!==null){let et=h.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let xt=!1;et.length!==z.cameras.length&&(z.cameras.length=0,xt=!0);for(let Pt=0;Pt<et.length;Pt++){let jt=et[Pt],ne=null;if(f!==null)ne=f.getViewport(jt);else{let Qt=u.getViewSubImage(d,jt);ne=Qt.viewport,Pt===0&&(t.setRenderTargetTextures(b,Qt.colorTexture,Qt.depthStencilTexture),t.setRenderTarget(b))}let Ut=B[Pt];Ut===void 0&&(Ut=new $e,Ut.layers.enable(Pt),Ut.viewport=new me,B[Pt]=Ut),Ut.matrix.fromArray(jt.transform.matrix),Ut.matrix.decompose(Ut.position,Ut.quaternion,Ut.scale),Ut.projectionMatrix.fromArray(jt.projectionMatrix),Ut.projectionMatrixInverse.copy(Ut.projectionMatrix).invert(),Ut.viewport.set(ne.x,ne.y,ne.width,ne.height),Pt===0&&(z.matrix.copy(Ut.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),xt===!0&&z.cameras.push(Ut)}let ft=n.enabledFeatures;if(ft&&ft.includes("depth-sensing")&&n.depthUsage=="gpu-optimized"&&x){u=i.getBinding();let Pt=u.getDepthInformation(et[0]);Pt&&Pt.isValid&&Pt.texture&&p.init(Pt,n.renderState)}if(ft&&ft.includes("camera-access")&&x){t.state.unbindTexture(),u=i.getBinding();for(let Pt=0;Pt<et.length;Pt++){let jt=et[Pt].camera;if(jt){let ne=m[jt];ne||(ne=new hr,m[jt]=ne);let Ut=u.getCameraImage(jt);ne.sourceTexture=Ut}}}}for(let et=0;et<A.length;et++){let xt=E[et],ft=A[et];xt!==null&&ft!==void 0&&ft.update(xt,dt,l||o)}tt&&tt(Y,dt),dt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:dt}),g=null}let Tt=new Yd;Tt.setAnimationLoop(yt),this.setAnimationLoop=function(Y){tt=Y},this.dispose=function(){}}},ty=new re,sf=new Ft;sf.set(-1,0,0,0,1,0,0,0,1);function ey(s,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,Jl(s)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function n(p,m,S,C,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,b)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),x(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?c(p,m,S,C):m.isSpriteMaterial?l(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Ke&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Ke&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let S=t.get(m),C=S.envMap,b=S.envMapRotation;C&&(p.envMap.value=C,p.envMapRotation.value.setFromMatrix4(ty.makeRotationFromEuler(b)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(sf),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function c(p,m,S,C){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*S,p.scale.value=C*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function l(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,S){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Ke&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=S.texture,p.transmissionSamplerSize.value.set(S.width,S.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function x(p,m){let S=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(S.matrixWorld),p.nearDistance.value=S.shadow.camera.near,p.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:n}}function iy(s,t,e,i){let n={},r={};function o(S,C){let b=C.program;i.uniformBlockBinding(S,b,n[S.id])}function a(S,C){let b=n[S.id];b===void 0&&(g(S),b=c(S),n[S.id]=b,S.addEventListener("dispose",p));let A=C.program;i.updateUBOMapping(S,A);let E=t.render.frame;r[S.id]!==E&&(l(S),r[S.id]=E)}function c(S){let C=s.createBuffer(),b=S.__size,A=S.usage;return s.bindBuffer(s.UNIFORM_BUFFER,C),s.bufferData(s.UNIFORM_BUFFER,b,A),s.bindBuffer(s.UNIFORM_BUFFER,null),C}function l(S){let C=n[S.id],b=S.uniforms,A=S.__cache;s.bindBuffer(s.UNIFORM_BUFFER,C);for(let E=0,_=b.length;E<_;E++){let M=b[E];if(Array.isArray(M))for(let F=0,P=M.length;F<P;F++)h(M[F],E,F,A);else h(M,E,0,A)}s.bindBuffer(s.UNIFORM_BUFFER,null)}function h(S,C,b,A){if(d(S,C,b,A)===!0){let E=S.__offset,_=S.value;if(Array.isArray(_)){let M=0;for(let F=0;F<_.length;F++){let P=_[F],L=x(P,!0);u(P,S.__data,M),M+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,S.__data,0);s.bufferSubData(s.UNIFORM_BUFFER,E,S.__data)}}function u(S,C,b){typeof S=="number"||typeof S=="boolean"?C[b]=S:S.isMatrix3?(C[b]=S.elements[0],C[b+1]=S.elements[1],C[b+2]=S.elements[2],C[b+3]=0,C[b+4]=S.elements[3],C[b+5]=S.elements[4],C[b+6]=S.elements[5],C[b+7]=0,C[b+8]=S.elements[6],C[b+9]=S.elements[7],C[b+10]=S.elements[8],C[b+11]=0):ArrayBuffer.isView(S)?C.set(S.subarray(0,C.length-b),b):S.toArray(C,b)}function d(S,C,b,A){let E=S.value,_=C+"_"+b;if(Array.isArray(E)){A[_]===void 0&&(A[_]=[]);let M=A[_],F=!1;for(let P=0;P<E.length;P++)f(E[P],M,P)===!0&&(F=!0);return F}return f(E,A,_)}function f(S,C,b){if(C[b]===void 0)return typeof S=="number"||typeof S=="boolean"?C[b]=S:ArrayBuffer.isView(S)?C[b]=S.slice():C[b]=S.clone(),!0;{let A=C[b];if(typeof S=="number"||typeof S=="boolean"){if(A!==S)return C[b]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(A.equals(S)===!1)return A.copy(S),!0}}return!1}function g(S){let C=S.uniforms,b=0,A=16;for(let _=0,M=C.length;_<M;_++){let F=Array.isArray(C[_])?C[_]:[C[_]];for(let P=0,L=F.length;P<L;P++){let B=F[P],z=Array.isArray(B.value)?B.value:[B.value],T=Array.isArray(C[_])||Array.isArray(B.value),V=b;for(let G=0,Q=z.length;G<Q;G++){let X=z[G],J=x(X,T),tt=b%A,yt=tt%J.boundary,Tt=tt+yt;b+=yt,Tt!==0&&A-Tt<J.storage&&(b+=A-Tt),G===0&&(V=b),b+=J.storage}let W=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new W((b-V)/Float32Array.BYTES_PER_ELEMENT),B.__offset=V}}let E=b%A;return E>0&&(b+=A-E),S.__size=b,S.__cache={},this}function x(S,C){let b={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(b.boundary=4,b.storage=4):S.isVector2?(b.boundary=8,b.storage=8):S.isVector3||S.isColor?(b.boundary=16,b.storage=12):S.isVector4?(b.boundary=16,b.storage=16):S.isMatrix3?(b.boundary=16,b.storage=48):S.isMatrix4?(b.boundary=16,b.storage=64):S.isTexture?It("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(b.boundary=16,b.storage=S.byteLength):It("WebGLRenderer: Unsupported uniform value type.",S),C===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(S){let C=S.target;C.removeEventListener("dispose",p),s.deleteBuffer(n[C.id]),delete n[C.id],delete r[C.id]}function m(){for(let S in n)s.deleteBuffer(n[S]);n={},r={}}return{bind:o,update:a,dispose:m}}var ny=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ki=null;function sy(){return ki===null&&(ki=new rr(ny,16,16,Tn,Pi),ki.name="DFG_LUT",ki.minFilter=Ze,ki.magFilter=Ze,ki.wrapS=Fi,ki.wrapT=Fi,ki.generateMipmaps=!1,ki.needsUpdate=!0),ki}var Qa=class{constructor(t={}){let{canvas:e=gd(),context:i=null,depth:n=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ei}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let x=f,p=new Set([xa,_a,ga]),m=new Set([ei,Ri,Ps,Yn,fa,pa]),S=new Uint32Array(4),C=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,E=null,_=[],M=[],F=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ui,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,L=!1,B=null,z=null,T=null,V=null;this._outputColorSpace=oi;let W=0,G=0,Q=null,X=-1,J=null,tt=new me,yt=new me,Tt=null,Y=new At(0),dt=0,et=e.width,xt=e.height,ft=1,Nt=null,ge=null,Pt=new me(0,0,et,xt),jt=new me(0,0,et,xt),ne=!1,Ut=new _n,Qt=new Wo,be=!1,ti=!1,_e=new re,Di=new D,Ce=new me,ui={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},di=!1;function fi(){return Q===null?ft:1}let N=i;function pi(v,I){return e.getContext(v,I)}let fe,pe,pt,we,Dt,Bt,w,y,U,it,j,rt,ht,$,Z,at,R,K,q,ct,st,ot,wt;try{let v={alpha:!0,depth:n,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ct,!1),e.addEventListener("webglcontextrestored",kt,!1),e.addEventListener("webglcontextcreationerror",mt,!1),N===null){let I="webgl2";if(N=pi(I,v),N===null)throw pi(I)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}zt()}catch(v){throw e.removeEventListener("webglcontextlost",Ct,!1),e.removeEventListener("webglcontextrestored",kt,!1),e.removeEventListener("webglcontextcreationerror",mt,!1),Lt("WebGLRenderer: "+v.message),v}function zt(){fe=new m_(N),fe.init(),st=new Kx(N,fe),pe=new s_(N,fe,t,st),pt=new Zx(N,fe),pe.reversedDepthBuffer&&d&&pt.buffers.depth.setReversed(!0),z=N.createFramebuffer(),T=N.createFramebuffer(),V=N.createFramebuffer(),we=new x_(N),Dt=new Fx,Bt=new Jx(N,fe,pt,Dt,pe,st,we),w=new p_(P),y=new vm(N),ot=new i_(N,y),U=new g_(N,y,we,ot),it=new v_(N,U,y,ot,we),K=new y_(N,pe,Bt),Z=new r_(Dt),j=new Nx(P,w,fe,pe,ot,Z),rt=new ey(P,Dt),ht=new Ox,$=new Hx(fe),R=new e_(P,w,pt,it,g,c),at=new $x(P,it,pe),wt=new iy(N,we,pe,pt),q=new n_(N,fe,we),ct=new __(N,fe,we),we.programs=j.programs,P.capabilities=pe,P.extensions=fe,P.properties=Dt,P.renderLists=ht,P.shadowMap=at,P.state=pt,P.info=we}x!==ei&&(F=new M_(x,e.width,e.height,a,n,r));let nt=new lh(P,N);this.xr=nt,this.getContext=function(){return N},this.getContextAttributes=function(){return N.getContextAttributes()},this.forceContextLoss=function(){let v=fe.get("WEBGL_lose_context");v&&v.loseContext()},this.forceContextRestore=function(){let v=fe.get("WEBGL_lose_context");v&&v.restoreContext()},this.getPixelRatio=function(){return ft},this.setPixelRatio=function(v){v!==void 0&&(ft=v,this.setSize(et,xt,!1))},this.getSize=function(v){return v.set(et,xt)},this.setSize=function(v,I,H=!0){if(nt.isPresenting){It("WebGLRenderer: Can't change size while VR device is presenting.");return}et=v,xt=I,e.width=Math.floor(v*ft),e.height=Math.floor(I*ft),H===!0&&(e.style.width=v+"px",e.style.height=I+"px"),F!==null&&F.setSize(e.width,e.height),this.setViewport(0,0,v,I)},this.getDrawingBufferSize=function(v){return v.set(et*ft,xt*ft).floor()},this.setDrawingBufferSize=function(v,I,H){et=v,xt=I,ft=H,e.width=Math.floor(v*H),e.height=Math.floor(I*H),this.setViewport(0,0,v,I)},this.setEffects=function(v){if(x===ei){Lt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(v){for(let I=0;I<v.length;I++)if(v[I].isOutputPass===!0){It("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(v||[])},this.getCurrentViewport=function(v){return v.copy(tt)},this.getViewport=function(v){return v.copy(Pt)},this.setViewport=function(v,I,H,O){v.isVector4?Pt.set(v.x,v.y,v.z,v.w):Pt.set(v,I,H,O),pt.viewport(tt.copy(Pt).multiplyScalar(fi()).round())},this.getScissor=function(v){return v.copy(jt)},this.setScissor=function(v,I,H,O){v.isVector4?jt.set(v.x,v.y,v.z,v.w):jt.set(v,I,H,O),pt.scissor(yt.copy(jt).multiplyScalar(fi()).round())},this.getScissorTest=function(){return ne},this.setScissorTest=function(v){pt.setScissorTest(ne=v)},this.setOpaqueSort=function(v){Nt=v},this.setTransparentSort=function(v){ge=v},this.getClearColor=function(v){return v.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(v=!0,I=!0,H=!0){let O=0;if(v){let k=!1;if(Q!==null){let ut=Q.texture.format;k=p.has(ut)}if(k){let ut=Q.texture.type,vt=m.has(ut),lt=R.getClearColor(),_t=R.getClearAlpha(),bt=lt.r,Ot=lt.g,Xt=lt.b;vt?(S[0]=bt,S[1]=Ot,S[2]=Xt,S[3]=_t,N.clearBufferuiv(N.COLOR,0,S)):(C[0]=bt,C[1]=Ot,C[2]=Xt,C[3]=_t,N.clearBufferiv(N.COLOR,0,C))}else O|=N.COLOR_BUFFER_BIT}I&&(O|=N.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(O|=N.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),O!==0&&N.clear(O)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(v){v.setRenderer(this),B=v},this.dispose=function(){e.removeEventListener("webglcontextlost",Ct,!1),e.removeEventListener("webglcontextrestored",kt,!1),e.removeEventListener("webglcontextcreationerror",mt,!1),R.dispose(),ht.dispose(),$.dispose(),Bt.dispose(),Dt.dispose(),w.dispose(),it.dispose(),U.dispose(),ot.dispose(),wt.dispose(),j.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Vh),nt.removeEventListener("sessionend",Hh),In.stop()};function Ct(v){v.preventDefault(),ql("WebGLRenderer: Context Lost."),L=!0}function kt(){ql("WebGLRenderer: Context Restored."),L=!1;let v=we.autoReset,I=at.enabled,H=at.autoUpdate,O=at.needsUpdate,k=at.type;zt(),we.autoReset=v,at.enabled=I,at.autoUpdate=H,at.needsUpdate=O,at.type=k}function mt(v){Lt("WebGLRenderer: A WebGL context could not be created. Reason: ",v.statusMessage)}function ce(v){let I=v.target;I.removeEventListener("dispose",ce),Re(I)}function Re(v){hn(v),Dt.remove(v)}function hn(v){let I=Dt.get(v).programs;I!==void 0&&(I.forEach(function(H){j.releaseProgram(H)}),v.isShaderMaterial&&j.releaseShaderCache(v))}this.renderBufferDirect=function(v,I,H,O,k,ut){I===null&&(I=ui);let vt=k.isMesh&&k.matrixWorld.determinantAffine()<0,lt=up(v,I,H,O,k);pt.setMaterial(O,vt);let _t=H.index,bt=1;if(O.wireframe===!0){if(_t=U.getWireframeAttribute(H),_t===void 0)return;bt=2}let Ot=H.drawRange,Xt=H.attributes.position,St=Ot.start*bt,qt=(Ot.start+Ot.count)*bt;ut!==null&&(St=Math.max(St,ut.start*bt),qt=Math.min(qt,(ut.start+ut.count)*bt)),_t!==null?(St=Math.max(St,0),qt=Math.min(qt,_t.count)):Xt!=null&&(St=Math.max(St,0),qt=Math.min(qt,Xt.count));let ve=qt-St;if(ve<0||ve===1/0)return;ot.setup(k,O,lt,H,_t);let ue,he=q;if(_t!==null&&(ue=y.get(_t),he=ct,he.setIndex(ue)),k.isMesh)O.wireframe===!0?(pt.setLineWidth(O.wireframeLinewidth*fi()),he.setMode(N.LINES)):he.setMode(N.TRIANGLES);else if(k.isLine){let ke=O.linewidth;ke===void 0&&(ke=1),pt.setLineWidth(ke*fi()),k.isLineSegments?he.setMode(N.LINES):k.isLineLoop?he.setMode(N.LINE_LOOP):he.setMode(N.LINE_STRIP)}else k.isPoints?he.setMode(N.POINTS):k.isSprite&&he.setMode(N.TRIANGLES);if(k.isBatchedMesh)if(fe.get("WEBGL_multi_draw"))he.renderMultiDraw(k._multiDrawStarts,k._multiDrawCounts,k._multiDrawCount);else{let ke=k._multiDrawStarts,Mt=k._multiDrawCounts,qe=k._multiDrawCount,te=_t?y.get(_t).bytesPerElement:1,Dn=Dt.get(O).currentProgram.getUniforms();for(let ze=0;ze<qe;ze++)Dn.setValue(N,"_gl_DrawID",ze),he.render(ke[ze]/te,Mt[ze])}else if(k.isInstancedMesh)he.renderInstances(St,ve,k.count);else if(H.isInstancedBufferGeometry){let ke=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,Mt=Math.min(H.instanceCount,ke);he.renderInstances(St,ve,Mt)}else he.render(St,ve)};function Gh(v,I,H,O){B!==null&&v.isNodeMaterial&&B.setObject(O,v),be===!0&&Z.setState(v,H,!1),v.transparent===!0&&v.side===He&&v.forceSinglePass===!1?(v.side=Ke,v.needsUpdate=!0,ks(v,I,O),v.side=An,v.needsUpdate=!0,ks(v,I,O),v.side=He):ks(v,I,O)}this.compile=function(v,I,H=null){H===null&&(H=v),B!==null&&B.renderStart(v,I,H),E=$.get(H),E.init(I),M.push(E),H.traverseVisible(function(k){k.isLight&&k.layers.test(I.layers)&&(E.pushLight(k),k.castShadow&&E.pushShadow(k))}),v!==H&&v.traverseVisible(function(k){k.isLight&&k.layers.test(I.layers)&&(E.pushLight(k),k.castShadow&&E.pushShadow(k))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),ti=this.localClippingEnabled,be=Z.init(this.clippingPlanes,ti),be===!0&&Z.setGlobalState(this.clippingPlanes,I),B!==null&&at.render(E.state.shadowsArray,H,I);let O=new Set;return v.traverse(function(k){if(!(k.isMesh||k.isPoints||k.isLine||k.isSprite))return;let ut=k.material;if(ut)if(Array.isArray(ut))for(let vt=0;vt<ut.length;vt++){let lt=ut[vt];Gh(lt,H,I,k),O.add(lt)}else Gh(ut,H,I,k),O.add(ut)}),E=M.pop(),B!==null&&B.renderEnd(),O},this.compileAsync=function(v,I,H=null){let O=this.compile(v,I,H);return new Promise(k=>{function ut(){if(O.forEach(function(vt){let _t=Dt.get(vt).currentProgram;(_t===void 0||_t.isReady())&&O.delete(vt)}),O.size===0){k(v);return}setTimeout(ut,10)}fe.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let kc=null;function lp(v){kc&&kc(v)}function Vh(){In.stop()}function Hh(){In.start()}let In=new Yd;In.setAnimationLoop(lp),typeof self<"u"&&In.setContext(self),this.setAnimationLoop=function(v){kc=v,nt.setAnimationLoop(v),v===null?In.stop():In.start()},nt.addEventListener("sessionstart",Vh),nt.addEventListener("sessionend",Hh),this.render=function(v,I){if(I!==void 0&&I.isCamera!==!0){Lt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;B!==null&&B.renderStart(v,I);let H=nt.enabled===!0&&nt.isPresenting===!0,O=F!==null&&(Q===null||H)&&F.begin(P,Q);if(v.matrixWorldAutoUpdate===!0&&v.updateMatrixWorld(),I.parent===null&&I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(I),I=nt.getCamera()),v.isScene===!0&&v.onBeforeRender(P,v,I,Q),E=$.get(v,M.length),E.init(I),E.state.textureUnits=Bt.getTextureUnits(),M.push(E),_e.multiplyMatrices(I.projectionMatrix,I.matrixWorldInverse),I.isArrayCamera?Qt.setFromArrayCamera(I):Ut.setFromProjectionMatrix(_e,_i,I.reversedDepth),ti=this.localClippingEnabled,be=Z.init(this.clippingPlanes,ti),A=ht.get(v,_.length),A.init(),_.push(A),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let vt=P.xr.getDepthSensingMesh();vt!==null&&zc(vt,I,-1/0,P.sortObjects)}zc(v,I,0,P.sortObjects),A.finish(),B!==null&&B.updateLights(E.state.lightsArray),P.sortObjects===!0&&A.sort(Nt,ge),di=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,di&&R.addToRenderList(A,v),this.info.autoReset===!0&&this.info.reset(),be===!0&&Z.beginShadows();let k=E.state.shadowsArray;if(at.render(k,v,I),be===!0&&Z.endShadows(),(O&&F.hasRenderPass())===!1){let vt=A.opaque,lt=A.transmissive;if(E.setupLights(),I.isArrayCamera){let _t=I.cameras;if(lt.length>0)for(let bt=0,Ot=_t.length;bt<Ot;bt++){let Xt=_t[bt];Xh(vt,lt,v,Xt)}di&&R.render(v);for(let bt=0,Ot=_t.length;bt<Ot;bt++){let Xt=_t[bt];Wh(A,v,Xt,Xt.viewport)}}else lt.length>0&&Xh(vt,lt,v,I),di&&R.render(v),Wh(A,v,I)}Q!==null&&G===0&&(Bt.updateMultisampleRenderTarget(Q),Bt.updateRenderTargetMipmap(Q)),O&&F.end(P),v.isScene===!0&&v.onAfterRender(P,v,I),ot.resetDefaultState(),X=-1,J=null,M.pop(),M.length>0?(E=M[M.length-1],Bt.setTextureUnits(E.state.textureUnits),be===!0&&Z.setGlobalState(P.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,B!==null&&B.renderEnd()};function zc(v,I,H,O){if(v.visible===!1)return;if(v.layers.test(I.layers)){if(v.isGroup)H=v.renderOrder;else if(v.isLOD)v.autoUpdate===!0&&v.update(I);else if(v.isLight)E.pushLight(v),v.castShadow&&E.pushShadow(v);else if(v.isSprite){let vt=I.isArrayCamera?Qt:Ut;if(!v.frustumCulled||v.intersectsFrustum(vt)){O&&Ce.setFromMatrixPosition(v.matrixWorld).applyMatrix4(_e);let lt=it.update(v),_t=v.material;_t.visible&&A.push(v,lt,_t,H,Ce.z,null,I)}}else if(v.isMesh||v.isLine||v.isPoints){let vt=I.isArrayCamera?Qt:Ut;if(!v.frustumCulled||v.intersectsFrustum(vt)){let lt=it.update(v),_t=v.material;if(O&&(v.boundingSphere!==void 0?(v.boundingSphere===null&&v.computeBoundingSphere(),Ce.copy(v.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),Ce.copy(lt.boundingSphere.center)),Ce.applyMatrix4(v.matrixWorld).applyMatrix4(_e)),Array.isArray(_t)){let bt=lt.groups;for(let Ot=0,Xt=bt.length;Ot<Xt;Ot++){let St=bt[Ot],qt=_t[St.materialIndex];qt&&qt.visible&&A.push(v,lt,qt,H,Ce.z,St,I)}}else _t.visible&&A.push(v,lt,_t,H,Ce.z,null,I)}}}let ut=v.children;for(let vt=0,lt=ut.length;vt<lt;vt++)zc(ut[vt],I,H,O)}function Wh(v,I,H,O){let{opaque:k,transmissive:ut,transparent:vt}=v;E.setupLightsView(H),be===!0&&Z.setGlobalState(P.clippingPlanes,H),O&&pt.viewport(tt.copy(O)),k.length>0&&Vr(k,I,H),ut.length>0&&Vr(ut,I,H),vt.length>0&&Vr(vt,I,H),pt.buffers.depth.setTest(!0),pt.buffers.depth.setMask(!0),pt.buffers.color.setMask(!0),pt.setPolygonOffset(!1)}function Xh(v,I,H,O){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[O.id]===void 0){let St=fe.has("EXT_color_buffer_half_float")||fe.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[O.id]=new ai(1,1,{generateMipmaps:!0,type:St?Pi:ei,minFilter:en,samples:Math.max(4,pe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:$t.workingColorSpace})}let ut=E.state.transmissionRenderTarget[O.id],vt=O.viewport||tt;ut.setSize(vt.z*P.transmissionResolutionScale,vt.w*P.transmissionResolutionScale);let lt=P.getRenderTarget(),_t=P.getActiveCubeFace(),bt=P.getActiveMipmapLevel();P.setRenderTarget(ut),P.getClearColor(Y),dt=P.getClearAlpha(),dt<1&&P.setClearColor(16777215,.5),P.clear(),di&&R.render(H);let Ot=P.toneMapping;P.toneMapping=Ui;let Xt=O.viewport;if(O.viewport!==void 0&&(O.viewport=void 0),E.setupLightsView(O),be===!0&&Z.setGlobalState(P.clippingPlanes,O),Vr(v,H,O),Bt.updateMultisampleRenderTarget(ut),Bt.updateRenderTargetMipmap(ut),fe.has("WEBGL_multisampled_render_to_texture")===!1){let St=!1;for(let qt=0,ve=I.length;qt<ve;qt++){let ue=I[qt],{object:he,geometry:ke,material:Mt,group:qe}=ue;if(Mt.side===He&&he.layers.test(O.layers)){let te=Mt.side;Mt.side=Ke,Mt.needsUpdate=!0,qh(he,H,O,ke,Mt,qe),Mt.side=te,Mt.needsUpdate=!0,St=!0}}St===!0&&(Bt.updateMultisampleRenderTarget(ut),Bt.updateRenderTargetMipmap(ut))}P.setRenderTarget(lt,_t,bt),P.setClearColor(Y,dt),Xt!==void 0&&(O.viewport=Xt),P.toneMapping=Ot}function Vr(v,I,H){let O=I.isScene===!0?I.overrideMaterial:null;for(let k=0,ut=v.length;k<ut;k++){let vt=v[k],{object:lt,geometry:_t,group:bt}=vt,Ot=vt.material;Ot.allowOverride===!0&&O!==null&&(Ot=O),lt.layers.test(H.layers)&&qh(lt,I,H,_t,Ot,bt)}}function qh(v,I,H,O,k,ut){B!==null&&k.isNodeMaterial&&B.setObject(v,k),v.onBeforeRender(P,I,H,O,k,ut),v.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,v.matrixWorld),v.normalMatrix.getNormalMatrix(v.modelViewMatrix),k.onBeforeRender(P,I,H,O,v,ut),k.transparent===!0&&k.side===He&&k.forceSinglePass===!1?(k.side=Ke,k.needsUpdate=!0,P.renderBufferDirect(H,I,O,k,v,ut),k.side=An,k.needsUpdate=!0,P.renderBufferDirect(H,I,O,k,v,ut),k.side=He):P.renderBufferDirect(H,I,O,k,v,ut),v.onAfterRender(P,I,H,O,k,ut)}function Yh(v){let I=0;for(let H of v)H.texture!==null&&I++;return I}function ks(v,I,H){I.isScene!==!0&&(I=ui);let O=Dt.get(v),k=E.state.lights,ut=E.state.shadowsArray,vt=k.state.version,lt=j.getParameters(v,k.state,ut,I,H,E.state.lightProbeGridArray),_t=j.getProgramCacheKey(lt),bt=O.programs;O.environment=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?I.environment:null,O.fog=I.fog;let Ot=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap;O.envMap=w.get(v.envMap||O.environment,Ot),O.envMapRotation=O.environment!==null&&v.envMap===null?I.environmentRotation:v.envMapRotation,bt===void 0&&(v.addEventListener("dispose",ce),bt=new Map,O.programs=bt,O.programVariants=new Map);let Xt=bt.get(_t);if(Xt!==void 0){if(O.currentProgram===Xt&&O.lightsStateVersion===vt)return Zh(v,lt),Xt}else lt.uniforms=j.getUniforms(v),B!==null&&v.isNodeMaterial&&B.build(v,H,lt),v.onBeforeCompile(lt,P),Xt=j.acquireProgram(lt,_t),bt.set(_t,Xt),O.uniforms=lt.uniforms;let St=O.uniforms;return(!v.isShaderMaterial&&!v.isRawShaderMaterial||v.clipping===!0)&&(St.clippingPlanes=Z.uniform),Zh(v,lt),O.needsLights=fp(v),O.lightsStateVersion=vt,O.needsLights&&(St.ambientLightColor.value=k.state.ambient,St.lightProbe.value=k.state.probe,St.sunLights.value=k.state.sun,St.sunLightShadows.value=k.state.sunShadow,St.directionalLights.value=k.state.directional,St.directionalLightShadows.value=k.state.directionalShadow,St.spotLights.value=k.state.spot,St.spotLightShadows.value=k.state.spotShadow,St.rectAreaLights.value=k.state.rectArea,St.ltc_1.value=k.state.rectAreaLTC1,St.ltc_2.value=k.state.rectAreaLTC2,St.pointLights.value=k.state.point,St.pointLightShadows.value=k.state.pointShadow,St.hemisphereLights.value=k.state.hemi,St.sunShadowMatrix.value=k.state.sunShadowMatrix,St.sunShadowCascade.value=k.state.sunShadowCascade,St.directionalShadowMatrix.value=k.state.directionalShadowMatrix,St.spotLightMatrix.value=k.state.spotLightMatrix,St.spotLightMap.value=k.state.spotLightMap,St.pointShadowMatrix.value=k.state.pointShadowMatrix),O.numLightProbeGrids=Yh(E.state.lightProbeGridArray),O.currentProgram=Xt,O.uniformsList=null,Xt}function hp(v,I,H,O,k){let ut=Dt.get(v),vt=ut.currentProgram.id+","+O+","+k,lt=ut.programVariants.get(vt);return lt===void 0?(lt=ks(v,I,H),ut.programVariants.set(vt,lt)):(ut.currentProgram=lt,ut.uniformsList=null,ut.outputColorSpace=O,ut.toneMapping=k),lt}function $h(v){if(v.uniformsList===null){let I=v.currentProgram.getUniforms();v.uniformsList=Ds.seqWithValue(I.seq,v.uniforms)}return v.uniformsList}function Zh(v,I){let H=Dt.get(v);H.outputColorSpace=I.outputColorSpace,H.batching=I.batching,H.batchingColor=I.batchingColor,H.instancing=I.instancing,H.instancingColor=I.instancingColor,H.instancingMorph=I.instancingMorph,H.skinning=I.skinning,H.morphTargets=I.morphTargets,H.morphNormals=I.morphNormals,H.morphColors=I.morphColors,H.morphTargetsCount=I.morphTargetsCount,H.numClippingPlanes=I.numClippingPlanes,H.numIntersection=I.numClipIntersection,H.vertexAlphas=I.vertexAlphas,H.vertexTangents=I.vertexTangents,H.toneMapping=I.toneMapping}function up(v,I,H,O,k){I.isScene!==!0&&(I=ui),Bt.resetTextureUnits();let ut=I.fog,vt=O.isMeshStandardMaterial||O.isMeshLambertMaterial||O.isMeshPhongMaterial?I.environment:null,lt=Q===null?P.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:$t.workingColorSpace,_t=O.isMeshStandardMaterial||O.isMeshLambertMaterial&&!O.envMap||O.isMeshPhongMaterial&&!O.envMap,bt=w.get(O.envMap||vt,_t),Ot=O.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,Xt=!!H.attributes.tangent&&(!!O.normalMap||O.anisotropy>0),St=!!H.morphAttributes.position,qt=!!H.morphAttributes.normal,ve=!!H.morphAttributes.color,ue=Ui;O.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&(ue=P.toneMapping);let he=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,ke=he!==void 0?he.length:0,Mt=Dt.get(O),qe=E.state.lights;if(be===!0&&(ti===!0||v!==J)){let xe=v===J&&O.id===X;Z.setState(O,v,xe)}let te=!1,Dn=!1;O.version===Mt.__version?Mt.needsLights&&Mt.lightsStateVersion!==qe.state.version||k.isBatchedMesh&&Mt.batching===!1||!k.isBatchedMesh&&Mt.batching===!0||k.isBatchedMesh&&Mt.batchingColor===!0&&k._colorsTexture===null||k.isBatchedMesh&&Mt.batchingColor===!1&&k._colorsTexture!==null||k.isInstancedMesh&&Mt.instancing===!1||!k.isInstancedMesh&&Mt.instancing===!0||k.isSkinnedMesh&&Mt.skinning===!1||!k.isSkinnedMesh&&Mt.skinning===!0||k.isInstancedMesh&&Mt.instancingColor===!0&&k.instanceColor===null||k.isInstancedMesh&&Mt.instancingColor===!1&&k.instanceColor!==null||k.isInstancedMesh&&Mt.instancingMorph===!0&&k.morphTexture===null||k.isInstancedMesh&&Mt.instancingMorph===!1&&k.morphTexture!==null||Mt.envMap!==bt||O.fog===!0&&Mt.fog!==ut||Mt.numClippingPlanes!==void 0&&(Mt.numClippingPlanes!==Z.numPlanes||Mt.numIntersection!==Z.numIntersection)||Mt.vertexAlphas!==Ot||Mt.vertexTangents!==Xt||Mt.morphTargets!==St||Mt.morphNormals!==qt||Mt.morphColors!==ve||Mt.morphTargetsCount!==ke||Mt.numLightProbeGrids!==Yh(E.state.lightProbeGridArray)?te=!0:(Mt.outputColorSpace!==lt||Mt.toneMapping!==ue)&&(Dn=!0):(te=!0,Mt.__version=O.version);let ze=Mt.currentProgram;(te===!0||Dn===!0)&&(ze=Dn===!0?hp(O,I,k,lt,ue):ks(O,I,k),B&&O.isNodeMaterial&&B.onUpdateProgram(O,ze,Mt));let Hr=!1,un=!1,Ln=!1,Jt=ze.getUniforms(),Oe=Mt.uniforms;if(pt.useProgram(ze.program)&&(Hr=!0,un=!0,Ln=!0),O.id!==X&&(X=O.id,un=!0),Hr||J!==v){pt.buffers.depth.getReversed()&&v.reversedDepth!==!0&&(v._reversedDepth=!0,v.updateProjectionMatrix()),Jt.setValue(N,"projectionMatrix",v.projectionMatrix),Jt.setValue(N,"viewMatrix",v.matrixWorldInverse);let Pe=Jt.map.cameraPosition;Pe!==void 0&&Pe.setValue(N,Di.setFromMatrixPosition(v.matrixWorld)),pe.logarithmicDepthBuffer&&Jt.setValue(N,"logDepthBufFC",2/(Math.log(v.far+1)/Math.LN2)),(O.isMeshPhongMaterial||O.isMeshToonMaterial||O.isMeshLambertMaterial||O.isMeshBasicMaterial||O.isMeshStandardMaterial||O.isShaderMaterial)&&Jt.setValue(N,"isOrthographic",v.isOrthographicCamera===!0),J!==v&&(J=v,un=!0,Ln=!0)}if(Mt.needsLights&&(qe.state.sunShadowMap.length>0&&Jt.setValue(N,"sunShadowMap",qe.state.sunShadowMap,Bt),qe.state.directionalShadowMap.length>0&&Jt.setValue(N,"directionalShadowMap",qe.state.directionalShadowMap,Bt),qe.state.spotShadowMap.length>0&&Jt.setValue(N,"spotShadowMap",qe.state.spotShadowMap,Bt),qe.state.pointShadowMap.length>0&&Jt.setValue(N,"pointShadowMap",qe.state.pointShadowMap,Bt)),k.isSkinnedMesh){Jt.setOptional(N,k,"bindMatrix"),Jt.setOptional(N,k,"bindMatrixInverse");let xe=k.skeleton;xe&&(xe.boneTexture===null&&xe.computeBoneTexture(),Jt.setValue(N,"boneTexture",xe.boneTexture,Bt))}k.isBatchedMesh&&(Jt.setOptional(N,k,"batchingTexture"),Jt.setValue(N,"batchingTexture",k._matricesTexture,Bt),Jt.setOptional(N,k,"batchingIdTexture"),Jt.setValue(N,"batchingIdTexture",k._indirectTexture,Bt),Jt.setOptional(N,k,"batchingColorTexture"),k._colorsTexture!==null&&Jt.setValue(N,"batchingColorTexture",k._colorsTexture,Bt));let Mi=H.morphAttributes;if((Mi.position!==void 0||Mi.normal!==void 0||Mi.color!==void 0)&&K.update(k,H,ze),(un||Mt.receiveShadow!==k.receiveShadow)&&(Mt.receiveShadow=k.receiveShadow,Jt.setValue(N,"receiveShadow",k.receiveShadow)),(O.isMeshStandardMaterial||O.isMeshLambertMaterial||O.isMeshPhongMaterial)&&O.envMap===null&&I.environment!==null&&(Oe.envMapIntensity.value=I.environmentIntensity),Oe.dfgLUT!==void 0&&(Oe.dfgLUT.value=sy()),un){if(Jt.setValue(N,"toneMappingExposure",P.toneMappingExposure),Mt.needsLights&&dp(Oe,Ln),ut&&O.fog===!0&&rt.refreshFogUniforms(Oe,ut),rt.refreshMaterialUniforms(Oe,O,ft,xt,E.state.transmissionRenderTarget[v.id]),Mt.needsLights&&Mt.numLightProbeGrids>0){let xe=b,Pe=0;for(let Vi of E.state.lightProbeGridArray)Vi.texture!==null&&(xe.textures[Pe]=Vi.texture,xe.min[Pe]=Vi.boundingBox.min,xe.max[Pe]=Vi.boundingBox.max,xe.resolution[Pe]=Vi.resolution,Pe++);for(let Vi in xe)xe[Vi].length=Pe;Oe.probesSH.value=xe.textures,Oe.probesMin.value=xe.min,Oe.probesMax.value=xe.max,Oe.probesResolution.value=xe.resolution}Ds.upload(N,$h(Mt),Oe,Bt)}if(O.isShaderMaterial&&O.uniformsNeedUpdate===!0&&(Ds.upload(N,$h(Mt),Oe,Bt),O.uniformsNeedUpdate=!1),O.isSpriteMaterial&&Jt.setValue(N,"center",k.center),Jt.setValue(N,"modelViewMatrix",k.modelViewMatrix),Jt.setValue(N,"normalMatrix",k.normalMatrix),Jt.setValue(N,"modelMatrix",k.matrixWorld),O.uniformsGroups!==void 0){let xe=O.uniformsGroups;for(let Pe=0,Vi=xe.length;Pe<Vi;Pe++){let Kh=xe[Pe];wt.update(Kh,ze),wt.bind(Kh,ze)}}return ze}function dp(v,I){v.ambientLightColor.needsUpdate=I,v.lightProbe.needsUpdate=I,v.sunLights.needsUpdate=I,v.sunLightShadows.needsUpdate=I,v.directionalLights.needsUpdate=I,v.directionalLightShadows.needsUpdate=I,v.pointLights.needsUpdate=I,v.pointLightShadows.needsUpdate=I,v.spotLights.needsUpdate=I,v.spotLightShadows.needsUpdate=I,v.rectAreaLights.needsUpdate=I,v.hemisphereLights.needsUpdate=I}function fp(v){return v.isMeshLambertMaterial||v.isMeshToonMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isShadowMaterial||v.isShaderMaterial&&v.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return Q},this.setRenderTargetTextures=function(v,I,H){let O=Dt.get(v);O.__autoAllocateDepthBuffer=v.resolveDepthBuffer===!1,O.__autoAllocateDepthBuffer===!1&&(O.__useRenderToTexture=!1),Dt.get(v.texture).__webglTexture=I,Dt.get(v.depthTexture).__webglTexture=O.__autoAllocateDepthBuffer?void 0:H,O.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(v,I){let H=Dt.get(v);H.__webglFramebuffer=I,H.__useDefaultFramebuffer=I===void 0},this.setRenderTarget=function(v,I=0,H=0){Q=v,W=I,G=H;let O=null,k=!1,ut=!1;if(v){let lt=Dt.get(v);if(lt.__useDefaultFramebuffer!==void 0){pt.bindFramebuffer(N.FRAMEBUFFER,lt.__webglFramebuffer),tt.copy(v.viewport),yt.copy(v.scissor),Tt=v.scissorTest,pt.viewport(tt),pt.scissor(yt),pt.setScissorTest(Tt),X=-1;return}else if(lt.__webglFramebuffer===void 0)Bt.setupRenderTarget(v);else if(lt.__hasExternalTextures)Bt.rebindTextures(v,Dt.get(v.texture).__webglTexture,Dt.get(v.depthTexture).__webglTexture);else if(v.depthBuffer){let Ot=v.depthTexture;if(lt.__boundDepthTexture!==Ot){if(Ot!==null&&Dt.has(Ot)&&(v.width!==Ot.image.width||v.height!==Ot.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Bt.setupDepthRenderbuffer(v)}}let _t=v.texture;(_t.isData3DTexture||_t.isDataArrayTexture||_t.isCompressedArrayTexture)&&(ut=!0);let bt=Dt.get(v).__webglFramebuffer;v.isWebGLCubeRenderTarget?(Array.isArray(bt[I])?O=bt[I][H]:O=bt[I],k=!0):v.samples>0&&Bt.useMultisampledRTT(v)===!1?O=Dt.get(v).__webglMultisampledFramebuffer:Array.isArray(bt)?O=bt[H]:O=bt,tt.copy(v.viewport),yt.copy(v.scissor),Tt=v.scissorTest}else tt.copy(Pt).multiplyScalar(ft).floor(),yt.copy(jt).multiplyScalar(ft).floor(),Tt=ne;if(H!==0&&(O=z),pt.bindFramebuffer(N.FRAMEBUFFER,O)&&pt.drawBuffers(v,O),pt.viewport(tt),pt.scissor(yt),pt.setScissorTest(Tt),k){let lt=Dt.get(v.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_CUBE_MAP_POSITIVE_X+I,lt.__webglTexture,H)}else if(ut){let lt=I;for(let _t=0;_t<v.textures.length;_t++){let bt=Dt.get(v.textures[_t]);N.framebufferTextureLayer(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0+_t,bt.__webglTexture,H,lt)}}else if(v!==null&&H!==0){let lt=Dt.get(v.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,lt.__webglTexture,H)}X=-1};function Jh(v){let I=Dt.get(v);return(I.__readFormat!==v.format||I.__readType!==v.type)&&(I.__readFormat=v.format,I.__readType=v.type,I.__formatReadable=pe.textureFormatReadable(v.format),I.__typeReadable=pe.textureTypeReadable(v.type)),I}this.readRenderTargetPixels=function(v,I,H,O,k,ut,vt,lt=0){if(!(v&&v.isWebGLRenderTarget)){Lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _t=Dt.get(v).__webglFramebuffer;if(v.isWebGLCubeRenderTarget&&vt!==void 0&&(_t=_t[vt],Array.isArray(_t)&&(_t=_t[0])),_t){pt.bindFramebuffer(N.FRAMEBUFFER,_t);try{let bt=v.textures[lt],Ot=bt.format,Xt=bt.type;v.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+lt);let St=Jh(bt);if(St.__formatReadable===!1){Lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(St.__typeReadable===!1){Lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}I>=0&&I<=v.width-O&&H>=0&&H<=v.height-k&&N.readPixels(I,H,O,k,st.convert(Ot),st.convert(Xt),ut)}finally{let bt=Q!==null?Dt.get(Q).__webglFramebuffer:null;pt.bindFramebuffer(N.FRAMEBUFFER,bt)}}},this.readRenderTargetPixelsAsync=async function(v,I,H,O,k,ut,vt,lt=0){if(!(v&&v.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _t=Dt.get(v).__webglFramebuffer;if(v.isWebGLCubeRenderTarget&&vt!==void 0&&(_t=_t[vt],Array.isArray(_t)&&(_t=_t[0])),_t)if(I>=0&&I<=v.width-O&&H>=0&&H<=v.height-k){pt.bindFramebuffer(N.FRAMEBUFFER,_t);let bt=v.textures[lt],Ot=bt.format,Xt=bt.type;v.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+lt);let St=Jh(bt);if(St.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(St.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let qt=N.createBuffer();N.bindBuffer(N.PIXEL_PACK_BUFFER,qt),N.bufferData(N.PIXEL_PACK_BUFFER,ut.byteLength,N.STREAM_READ),N.readPixels(I,H,O,k,st.convert(Ot),st.convert(Xt),0),N.bindBuffer(N.PIXEL_PACK_BUFFER,null);let ve=Q!==null?Dt.get(Q).__webglFramebuffer:null;pt.bindFramebuffer(N.FRAMEBUFFER,ve);let ue=N.fenceSync(N.SYNC_GPU_COMMANDS_COMPLETE,0);return N.flush(),await xd(N,ue,4),N.bindBuffer(N.PIXEL_PACK_BUFFER,qt),N.getBufferSubData(N.PIXEL_PACK_BUFFER,0,ut),N.bindBuffer(N.PIXEL_PACK_BUFFER,null),N.deleteBuffer(qt),N.deleteSync(ue),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(v,I=null,H=0){let O=Math.pow(2,-H),k=Math.floor(v.image.width*O),ut=Math.floor(v.image.height*O),vt=I!==null?I.x:0,lt=I!==null?I.y:0;Bt.setTexture2D(v,0),N.copyTexSubImage2D(N.TEXTURE_2D,H,0,0,vt,lt,k,ut),pt.unbindTexture()},this.copyTextureToTexture=function(v,I,H=null,O=null,k=0,ut=0){let vt,lt,_t,bt,Ot,Xt,St,qt,ve,ue=v.isCompressedTexture?v.mipmaps[ut]:v.image;if(H!==null)vt=H.max.x-H.min.x,lt=H.max.y-H.min.y,_t=H.isBox3?H.max.z-H.min.z:1,bt=H.min.x,Ot=H.min.y,Xt=H.isBox3?H.min.z:0;else{let Jt=Math.pow(2,-k);vt=Math.floor(ue.width*Jt),lt=Math.floor(ue.height*Jt),v.isDataArrayTexture?_t=ue.depth:v.isData3DTexture?_t=Math.floor(ue.depth*Jt):_t=1,bt=0,Ot=0,Xt=0}O!==null?(St=O.x,qt=O.y,ve=O.z):(St=0,qt=0,ve=0);let he=st.convert(I.format),ke=st.convert(I.type),Mt;I.isData3DTexture?(Bt.setTexture3D(I,0),Mt=N.TEXTURE_3D):I.isDataArrayTexture||I.isCompressedArrayTexture?(Bt.setTexture2DArray(I,0),Mt=N.TEXTURE_2D_ARRAY):(Bt.setTexture2D(I,0),Mt=N.TEXTURE_2D),pt.activeTexture(N.TEXTURE0),pt.pixelStorei(N.UNPACK_FLIP_Y_WEBGL,I.flipY),pt.pixelStorei(N.UNPACK_PREMULTIPLY_ALPHA_WEBGL,I.premultiplyAlpha),pt.pixelStorei(N.UNPACK_ALIGNMENT,I.unpackAlignment);let qe=pt.getParameter(N.UNPACK_ROW_LENGTH),te=pt.getParameter(N.UNPACK_IMAGE_HEIGHT),Dn=pt.getParameter(N.UNPACK_SKIP_PIXELS),ze=pt.getParameter(N.UNPACK_SKIP_ROWS),Hr=pt.getParameter(N.UNPACK_SKIP_IMAGES);pt.pixelStorei(N.UNPACK_ROW_LENGTH,ue.width),pt.pixelStorei(N.UNPACK_IMAGE_HEIGHT,ue.height),pt.pixelStorei(N.UNPACK_SKIP_PIXELS,bt),pt.pixelStorei(N.UNPACK_SKIP_ROWS,Ot),pt.pixelStorei(N.UNPACK_SKIP_IMAGES,Xt);let un=v.isDataArrayTexture||v.isData3DTexture,Ln=I.isDataArrayTexture||I.isData3DTexture;if(v.isDepthTexture){let Jt=Dt.get(v),Oe=Dt.get(I),Mi=Dt.get(Jt.__renderTarget),xe=Dt.get(Oe.__renderTarget);pt.bindFramebuffer(N.READ_FRAMEBUFFER,Mi.__webglFramebuffer),pt.bindFramebuffer(N.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let Pe=0;Pe<_t;Pe++)un&&(N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Dt.get(v).__webglTexture,k,Xt+Pe),N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Dt.get(I).__webglTexture,ut,ve+Pe)),N.blitFramebuffer(bt,Ot,bt+vt,Ot+lt,St,qt,St+vt,qt+lt,N.DEPTH_BUFFER_BIT,N.NEAREST);pt.bindFramebuffer(N.READ_FRAMEBUFFER,null),pt.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else if(k!==0||v.isRenderTargetTexture||Dt.has(v)){let Jt=Dt.get(v),Oe=Dt.get(I);pt.bindFramebuffer(N.READ_FRAMEBUFFER,T),pt.bindFramebuffer(N.DRAW_FRAMEBUFFER,V);for(let Mi=0;Mi<_t;Mi++)un?N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Jt.__webglTexture,k,Xt+Mi):N.framebufferTexture2D(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Jt.__webglTexture,k),Ln?N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Oe.__webglTexture,ut,ve+Mi):N.framebufferTexture2D(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Oe.__webglTexture,ut),k!==0?N.blitFramebuffer(bt,Ot,bt+vt,Ot+lt,St,qt,St+vt,qt+lt,N.COLOR_BUFFER_BIT,N.NEAREST):Ln?N.copyTexSubImage3D(Mt,ut,St,qt,ve+Mi,bt,Ot,vt,lt):N.copyTexSubImage2D(Mt,ut,St,qt,bt,Ot,vt,lt);pt.bindFramebuffer(N.READ_FRAMEBUFFER,null),pt.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else Ln?v.isDataTexture||v.isData3DTexture?N.texSubImage3D(Mt,ut,St,qt,ve,vt,lt,_t,he,ke,ue.data):I.isCompressedArrayTexture?N.compressedTexSubImage3D(Mt,ut,St,qt,ve,vt,lt,_t,he,ue.data):N.texSubImage3D(Mt,ut,St,qt,ve,vt,lt,_t,he,ke,ue):v.isDataTexture?N.texSubImage2D(N.TEXTURE_2D,ut,St,qt,vt,lt,he,ke,ue.data):v.isCompressedTexture?N.compressedTexSubImage2D(N.TEXTURE_2D,ut,St,qt,ue.width,ue.height,he,ue.data):N.texSubImage2D(N.TEXTURE_2D,ut,St,qt,vt,lt,he,ke,ue);pt.pixelStorei(N.UNPACK_ROW_LENGTH,qe),pt.pixelStorei(N.UNPACK_IMAGE_HEIGHT,te),pt.pixelStorei(N.UNPACK_SKIP_PIXELS,Dn),pt.pixelStorei(N.UNPACK_SKIP_ROWS,ze),pt.pixelStorei(N.UNPACK_SKIP_IMAGES,Hr),ut===0&&I.generateMipmaps===!0&&I.mipmapsAutoUpdate===!0&&N.generateMipmap(Mt),pt.unbindTexture()},this.initRenderTarget=function(v){Dt.get(v).__webglFramebuffer===void 0&&Bt.setupRenderTarget(v)},this.initTexture=function(v){v.isCubeTexture?Bt.setTextureCube(v,0):v.isData3DTexture?Bt.setTexture3D(v,0):v.isDataArrayTexture||v.isCompressedArrayTexture?Bt.setTexture2DArray(v,0):Bt.setTexture2D(v,0),pt.unbindTexture()},this.resetState=function(){W=0,G=0,Q=null,pt.reset(),ot.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return _i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=$t._getDrawingBufferColorSpace(t),e.unpackColorSpace=$t._getUnpackColorSpace()}};var rf={type:"change"},uh={type:"start"},af={type:"end"},ic=new Qi,of=new Ye,ry=Math.cos(70*$n.DEG2RAD),Te=new D,ii=2*Math.PI,ie={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},hh=1e-6,nc=class extends br{constructor(t,e=null){super(t,e),this.state=ie.NONE,this.target=new D,this.cursor=new D,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:wn.ROTATE,MIDDLE:wn.DOLLY,RIGHT:wn.PAN},this.touches={ONE:En.ROTATE,TWO:En.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new D,this._lastQuaternion=new Ne,this._lastTargetPosition=new D,this._quat=new Ne().setFromUnitVectors(t.up,new D(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new As,this._sphericalDelta=new As,this._scale=1,this._panOffset=new D,this._rotateStart=new Rt,this._rotateEnd=new Rt,this._rotateDelta=new Rt,this._panStart=new Rt,this._panEnd=new Rt,this._panDelta=new Rt,this._dollyStart=new Rt,this._dollyEnd=new Rt,this._dollyDelta=new Rt,this._dollyDirection=new D,this._mouse=new Rt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=ay.bind(this),this._onPointerDown=oy.bind(this),this._onPointerUp=cy.bind(this),this._onContextMenu=my.bind(this),this._onMouseWheel=uy.bind(this),this._onKeyDown=dy.bind(this),this._onTouchStart=fy.bind(this),this._onTouchMove=py.bind(this),this._onMouseDown=ly.bind(this),this._onMouseMove=hy.bind(this),this._interceptControlDown=gy.bind(this),this._interceptControlUp=_y.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ie.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(rf),this.update(),this.state=ie.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Te.copy(e).sub(this.target),Te.applyQuaternion(this._quat),this._spherical.setFromVector3(Te),this.autoRotate&&this.state===ie.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,n=this.maxAzimuthAngle;isFinite(i)&&isFinite(n)&&(i<-Math.PI?i+=ii:i>Math.PI&&(i-=ii),n<-Math.PI?n+=ii:n>Math.PI&&(n-=ii),i<=n?this._spherical.theta=Math.max(i,Math.min(n,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+n)/2?Math.max(i,this._spherical.theta):Math.min(n,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Te.setFromSpherical(this._spherical),Te.applyQuaternion(this._quatInverse),e.copy(this.target).add(Te),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Te.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new D(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new D(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Te.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ic.origin.copy(this.object.position),ic.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ic.direction))<ry?this.object.lookAt(this.target):(of.setFromNormalAndCoplanarPoint(this.object.up,this.target),ic.intersectPlane(of,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>hh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>hh||this._lastTargetPosition.distanceToSquared(this.target)>hh?(this.dispatchEvent(rf),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ii/60*this.autoRotateSpeed*t:ii/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Te.setFromMatrixColumn(e,0),Te.multiplyScalar(-t),this._panOffset.add(Te)}_panUp(t,e){this.screenSpacePanning===!0?Te.setFromMatrixColumn(e,1):(Te.setFromMatrixColumn(e,0),Te.crossVectors(this.object.up,Te)),Te.multiplyScalar(t),this._panOffset.add(Te)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let n=this.object.position;Te.copy(n).sub(this.target);let r=Te.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),n=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=n/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/e.clientHeight),this._rotateUp(ii*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),n=.5*(t.pageY+e.y);this._rotateStart.set(i,n)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),n=.5*(t.pageY+e.y);this._panStart.set(i,n)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,n=t.pageY-e.y,r=Math.sqrt(i*i+n*n);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),n=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(n,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/e.clientHeight),this._rotateUp(ii*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),n=.5*(t.pageY+e.y);this._panEnd.set(i,n)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,n=t.pageY-e.y,r=Math.sqrt(i*i+n*n);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Rt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function oy(s){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(s.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(s)&&(this._addPointer(s),s.pointerType==="touch"?this._onTouchStart(s):this._onMouseDown(s),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function ay(s){this.enabled!==!1&&(s.pointerType==="touch"?this._onTouchMove(s):this._onMouseMove(s))}function cy(s){switch(this._removePointer(s),this._pointers.length){case 0:this.domElement.releasePointerCapture(s.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(af),this.state=ie.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function ly(s){let t;switch(s.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case wn.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(s),this.state=ie.DOLLY;break;case wn.ROTATE:if(s.ctrlKey||s.metaKey||s.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(s),this.state=ie.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(s),this.state=ie.ROTATE}break;case wn.PAN:if(s.ctrlKey||s.metaKey||s.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(s),this.state=ie.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(s),this.state=ie.PAN}break;default:this.state=ie.NONE}this.state!==ie.NONE&&this.dispatchEvent(uh)}function hy(s){switch(this.state){case ie.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(s);break;case ie.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(s);break;case ie.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(s);break}}function uy(s){this.enabled===!1||this.enableZoom===!1||this.state!==ie.NONE||(s.preventDefault(),this.dispatchEvent(uh),this._handleMouseWheel(this._customWheelEvent(s)),this.dispatchEvent(af))}function dy(s){this.enabled!==!1&&this._handleKeyDown(s)}function fy(s){switch(this._trackPointer(s),this._pointers.length){case 1:switch(this.touches.ONE){case En.ROTATE:if(this.enableRotate===!1){this.state=ie.NONE;break}this._handleTouchStartRotate(s),this.state=ie.TOUCH_ROTATE;break;case En.PAN:if(this.enablePan===!1){this.state=ie.NONE;break}this._handleTouchStartPan(s),this.state=ie.TOUCH_PAN;break;default:this.state=ie.NONE}break;case 2:switch(this.touches.TWO){case En.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(s),this.state=ie.TOUCH_DOLLY_PAN;break;case En.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(s),this.state=ie.TOUCH_DOLLY_ROTATE;break;default:this.state=ie.NONE}break;default:this.state=ie.NONE}this.state!==ie.NONE&&this.dispatchEvent(uh)}function py(s){switch(this._trackPointer(s),this.state){case ie.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(s),this.update();break;case ie.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(s),this.update();break;case ie.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(s),this.update();break;case ie.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(s),this.update();break;default:this.state=ie.NONE}}function my(s){this.enabled!==!1&&s.preventDefault()}function gy(s){s.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function _y(s){s.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Fr(s,t){let e=Math.hypot(s[t],s[t+1],s[t+2],s[t+3]);if(!(e>0)){s[t]=1,s[t+1]=s[t+2]=s[t+3]=0;return}for(let i=0;i<4;i+=1)s[t+i]/=e}function Xe(s,t,e){let i=s[t],n=s[t+1],r=s[t+2],o=s[t+3];return e[0]=1-2*(r*r+o*o),e[1]=2*(n*r-i*o),e[2]=2*(n*o+i*r),e[3]=2*(n*r+i*o),e[4]=1-2*(n*n+o*o),e[5]=2*(r*o-i*n),e[6]=2*(n*o-i*r),e[7]=2*(r*o+i*n),e[8]=1-2*(n*n+r*r),e}function je(s,t){return[s[0]*t[0]+s[1]*t[1]+s[2]*t[2],s[3]*t[0]+s[4]*t[1]+s[5]*t[2],s[6]*t[0]+s[7]*t[1]+s[8]*t[2]]}function dh(s,t){return[s[0]*t[0]+s[3]*t[1]+s[6]*t[2],s[1]*t[0]+s[4]*t[1]+s[7]*t[2],s[2]*t[0]+s[5]*t[1]+s[8]*t[2]]}var xy=.5,Gi={field_of_view_rad:.6,margin:1.2,cameras:[{name:"front",from:[0,-1,.12]},{name:"side",from:[1,0,.12]},{name:"top",from:[0,-.001,1]},{name:"iso",from:[.85,-1.25,.75]}],light:{towards:[-.35,-.5,.9],lamp:.72,ambient:.32,sky:.3},fixture:"#4a5460",axes:["#c83c3c","#2f945a","#2f6fc4"]},uf=[.55,-1,.42],yy=1e-6,cf=(s,t)=>s[0]*t[0]+s[1]*t[1]+s[2]*t[2],lf=(s,t)=>[s[1]*t[2]-s[2]*t[1],s[2]*t[0]-s[0]*t[2],s[0]*t[1]-s[1]*t[0]],fh=(s,t,e=1)=>s.map((i,n)=>i+e*t[n]);function hf(s,t){let e=Math.hypot(...s);return e>0&&Number.isFinite(e)?s.map(i=>i/e):t}function ph(s){let t=[1/0,1/0,1/0],e=[-1/0,-1/0,-1/0];for(let i of s)for(let n=0;n<3;n+=1)t[n]=Math.min(t[n],i[n]),e[n]=Math.max(e[n],i[n]);return s.length>0?[t,e]:[[-.5,-.5,-.5],[.5,.5,.5]]}var mh=s=>Array.from({length:8},(t,e)=>[0,1,2].map(i=>s[e>>i&1][i]));function gh({box:s}){return s?Math.hypot(...[0,1,2].map(t=>Math.max(Math.abs(s[0][t]),Math.abs(s[1][t])))):xy}var _h=s=>{let[t,e]=ph(s);return t.map((i,n)=>(i+e[n])/2)};function sc(s,t){let e=s.frame?[...s.frame.moving,...s.frame.standing]:[];return e.length>0?e:ff(s,t,s.bodies.map((i,n)=>n))}function df(s,t){let{frame:e,moving:i}=s,n=[...ff(s,t,i),...e&&e.moving.length>0?e.standing:[]];return n.length>0?n:sc(s,t)}function ff(s,t,e){let i=new Float64Array(9);return e.flatMap(n=>{let{box:r,opacity:o}=s.bodies[n];return!r||o===0?[]:(Xe(t,7*n+3,i),mh(r).map(a=>je(i,a).map((c,l)=>c+t[7*n+l])))})}function pf(s,t,e,i,n=null){let r=hf(t,[0,-1,0]).map(d=>-d),o=hf(lf(r,[0,0,1]),[1,0,0]),a=lf(o,r),c=n??_h(s),l=1/0,h=c;for(let[d,f]of[[o,e],[a,i]]){let g=-1/0,x=-1/0;for(let p of s){let m=fh(p,c,-1),S=cf(m,r),C=cf(m,d);g=Math.max(g,C-f*S),x=Math.max(x,-C-f*S)}n?l=Math.min(l,-Math.max(g,x)/f):s.length>0&&(l=Math.min(l,-.5*(g+x)/f),h=fh(h,d,.5*(g-x)))}let u=s.length>0&&Number.isFinite(l)?Math.max(-l,yy):1;return{target:h,eye:fh(h,r,-u),distance:u}}var vy=["fit","home",...Gi.cameras.map(({name:s})=>s)],Sy=44,My=.6,by=5,rc=class{constructor(t,e,i=null){this.stage=t,this.shared=t.shared,this.home=i,this.changed=e,this.controls=new nc(t.camera,t.canvas),this.controls.addEventListener("change",e),this.tracked=null}get target(){return this.controls.target}direction(t){return t==="home"?this.home?.from??uf:this.shared.cameras.find(i=>i.name===t)?.from??this.stage.camera.position.clone().sub(this.target).toArray()}place(t,e,[i,n]){let r=e.isBox3?mh([e.min.toArray(),e.max.toArray()]):e,{camera:o,width:a,height:c}=this.stage,l=t==="home"?this.home:null;if(l?.eye)return{eye:l.eye,target:l.look_at??_h(r)};let[h,u]=[a/i||1,c/n||1],d=Math.tan($n.degToRad(o.fov/2))/this.shared.margin,f=Math.max(My,1-2*Sy/u);return pf(r,this.direction(t),d*h/u,d*f,l?.look_at??null)}distance(t,e,i){let{eye:n,target:r}=this.place(t,e,i);return Math.hypot(...n.map((o,a)=>o-r[a]))}look(t,e,i){let{camera:n}=this.stage,{eye:r,target:o}=this.place(t,e,i);this.target.set(...o),n.position.set(...r);let a=n.position.distanceTo(this.target);n.near=a/100,n.far=a*40,this.controls.update(),this.changed()}track(t){if(t&&this.tracked){let e=t.clone().sub(this.tracked);this.target.add(e),this.stage.camera.position.add(e)}else t&&(this.stage.camera.position.add(t.clone().sub(this.target)),this.target.copy(t));this.tracked=t,this.controls.update()}onClick(t,e){let{canvas:i,camera:n}=this.stage,r=null,o=(a,c)=>{let l=i.getBoundingClientRect(),[h,u]=t(),d=(a.clientX-l.left)/l.width*h,f=(a.clientY-l.top)/l.height*u,g=Math.min(h-1,Math.floor(d)),x=Math.min(u-1,Math.floor(f)),p=new Vn;p.setFromCamera(new Rt(2*(d-g)-1,1-2*(f-x)),n),e(p,x*h+g,c)};i.addEventListener("pointerdown",a=>{r=[a.clientX,a.clientY]}),i.addEventListener("pointerup",a=>{!r||Math.hypot(a.clientX-r[0],a.clientY-r[1])>by||o(a,!1)}),i.addEventListener("dblclick",a=>o(a,!0))}};function Jn(s,t,e){let i=new or(s,t,e);return i.instanceMatrix.setUsage(vi),i.frustumCulled=!1,i}function Ns(s,t,e,i=null){let n=new Ue(s,t);return n.isInstancedMesh=!0,n.instanceMatrix=i??new Ci(new Float32Array(16*e),16),n.instanceMatrix.setUsage(vi),n.instanceColor=null,n.morphTexture=null,n.count=e,n.frustumCulled=!1,n.raycast=()=>{},n}function rn(s,t,e,i,n,r){let o=16*t;s[o]=e[0],s[o+1]=e[1],s[o+2]=e[2],s[o+3]=0,s[o+4]=i[0],s[o+5]=i[1],s[o+6]=i[2],s[o+7]=0,s[o+8]=n[0],s[o+9]=n[1],s[o+10]=n[2],s[o+11]=0,s[o+12]=r[0],s[o+13]=r[1],s[o+14]=r[2],s[o+15]=1}var Fs=null;function Be(s){return Fs||(Fs=document.createElement("span"),Fs.hidden=!0,document.body.append(Fs)),Fs.style.color=`var(--${s})`,getComputedStyle(Fs).color}function mf(){let s=document.documentElement.style.colorScheme;return s?s==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function gf(s,t){let e=()=>{s.textContent=mf()?"Light":"Dark",t()};s.addEventListener("click",()=>{document.documentElement.style.colorScheme=mf()?"light":"dark",e()}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",e),e()}function xh(s,t,e,i,n){let[r,o]=e,a=Xe(i,7*n+3,new Float64Array(9)),c=je(a,r.map((h,u)=>(h+o[u])/2)),l=h=>je(a,[0,1,2].map(u=>u===h?o[h]-r[h]:0));rn(s,t,l(0),l(1),l(2),c.map((h,u)=>h+i[7*n+u]))}function yh(){return new dr(new yn(1,1,1))}var oc=class{constructor(t){this.view=t,this.bodies=t.run.bodies.map((i,n)=>n).filter(i=>t.run.bodies[i].box);let e=new ye({depthTest:!1,transparent:!0,opacity:.8});this.group=Ns(yh(),e,this.bodies.length),this.group.renderOrder=5}update(){let{run:t,snapshot:e}=this.view;this.group.material.color.copy(new At(Be("accent"))),this.bodies.forEach((i,n)=>{xh(this.group.instanceMatrix.array,n,t.bodies[i].box,e.poses,i)}),this.group.instanceMatrix.needsUpdate=!0}legend(){return[]}};function ac(s){if(!(s>0)||!Number.isFinite(s))return 1;let t=10**Math.floor(Math.log10(s));return([5,2,1].find(e=>e*t<=s*(1+1e-9))??1)*t}function vh(s){let t=[["km",1e3],["m",1],["cm",.01],["mm",.001],["µm",1e-6]],[e,i]=t.find(([,n])=>s>=n*(1-1e-9))??t.at(-1);return`${ni(s/i,3)} ${e}`}function ni(s,t=4){if(!Number.isFinite(s))return"–";if(s===0)return"0";let e=Math.abs(s);return e>=1e5||e<.001?s.toExponential(t-2).replace(/\.?0+e/,"e").replace("e+","e").replace("-","−").replace("e-","e−"):String(Number(s.toPrecision(t))).replace("-","−")}function Sh(s,t){let e=Math.min(6,Math.max(3,3-Math.floor(Math.log10(Math.max(t,1e-6)))));return`${s.toFixed(e)} s`}function cc(s,t){let e=s.filter(Number.isFinite).sort((i,n)=>i-n);return e.length===0?null:e[Math.round(t*(e.length-1))]}var _f=8,wy=2.8,Ey=7,Ay=.45,Ty=64;function xf(s){return s.rotateX(Math.PI/2).translate(0,0,.5)}var Qe=class{constructor(t,e){this.radius=e,this.group=new Ht;let i=new ci({color:t,depthTest:!1,depthWrite:!1,transparent:!0});this.shafts=Jn(xf(new vn(1,1,1,_f)),i,0),this.heads=Jn(xf(new ur(1,1,_f)),i,0),this.shafts.renderOrder=this.heads.renderOrder=10,this.group.add(this.shafts,this.heads),this.count=0,this.capacity=0,this.grow(Ty)}grow(t){for(let e of[this.shafts,this.heads]){let i=new Float32Array(16*t);i.set(e.instanceMatrix.array.subarray(0,16*this.count)),e.dispose(),e.instanceMatrix=new Ci(i,16),e.instanceMatrix.setUsage(vi)}this.capacity=t}clear(){this.count=0}add(t,e,i){let n=Math.hypot(e[0],e[1],e[2]),r=n*i;if(!(r>0)||!Number.isFinite(r))return;this.count===this.capacity&&this.grow(2*this.capacity);let o=[e[0]/n,e[1]/n,e[2]/n],[a,c]=Bs(o),l=Math.min(Ey*this.radius,Ay*r),h=Math.min(wy*this.radius,l/2),u=Math.min(this.radius,h/2),d=[0,1,2].map(x=>t[x]+o[x]*(r-l)),f=(x,p)=>[x[0]*p,x[1]*p,x[2]*p],{count:g}=this;rn(this.shafts.instanceMatrix.array,g,f(a,u),f(c,u),f(o,r-l),t),rn(this.heads.instanceMatrix.array,g,f(a,h),f(c,h),f(o,l),d),this.count+=1}show(){for(let t of[this.shafts,this.heads])t.count=this.count,t.instanceMatrix.needsUpdate=!0}};function Bs(s){let t=s[2]>=0?1:-1,e=-1/(t+s[2]),i=s[0]*s[1]*e;return[[1+t*s[0]*s[0]*e,t*i,-t*s[0]],[i,t+s[1]*s[1]*e,-s[1]]]}var Mh=["#5692cc","#e69f3c","#3ca57d","#d6693c","#cc82ac","#e2d050","#8080c8"],lc=["#3b82c4","#e0803a","#4ba35a","#c75b7a","#7d6cc7","#c2a02c","#2fa3a0","#a8623b","#8c9b30","#c45fb5"];var Br="#d8334a",Or="#a020a8",hc="#13988a",bh="#eba715",wh="#2677dd",Si="#e07f00",Ur="#8b46c9";var yf="#ff5a1f";var Cy=3*256,Cn=class{constructor(){this.geometry=new Kt,this.used=0,this.replace(new Float32Array(Cy))}replace(t){this.geometry.dispose(),this.array=t,this.geometry.setAttribute("position",new ee(t,3).setUsage(vi))}clear(){this.used=0}add(t,e,i){if(this.used+3>this.array.length){let n=new Float32Array(2*this.array.length);n.set(this.array),this.replace(n)}this.array[this.used]=t,this.array[this.used+1]=e,this.array[this.used+2]=i,this.used+=3}show(){this.geometry.setDrawRange(0,this.used/3),this.geometry.getAttribute("position").needsUpdate=!0}};var Ry=7,Py=.35,Iy=1.8,vf=.022,Dy=.9,Eh=1.5;function Ly(){let s=document.createElement("canvas");s.width=s.height=32;let t=s.getContext("2d");return t.fillStyle="#fff",t.arc(16,16,15,0,2*Math.PI),t.fill(),new cr(s)}var uc=class{constructor(t){this.view=t,this.group=new Ht,this.scale=t.scaleOf("force",Iy),this.arrows=new Qe(Br,vf*t.size),this.loads=new Qe(Or,vf*t.size),this.points=new Cn,this.stubs=new Cn;let e={depthTest:!1,depthWrite:!1,transparent:!0},i=new kn(this.points.geometry,new xn({color:hc,size:Ry*Math.min(2,devicePixelRatio),sizeAttenuation:!1,map:Ly(),alphaTest:.5,...e})),n=new Ue(this.stubs.geometry,new ye({color:hc,...e}));i.renderOrder=12,n.renderOrder=9,i.frustumCulled=n.frustumCulled=!1,this.group.add(this.arrows.group,this.loads.group,n,i)}update(){let{run:t,snapshot:e,size:i}=this.view;for(let o of[this.points,this.stubs,this.arrows,this.loads])o.clear();let n=[];e.eachContact((o,a,c,l)=>n.push(Math.abs(c[l+7]))),e.eachJointLoad((o,a,c)=>n.push(a[c+7])),this.scale.see(cc(n,Dy)??0);let{factor:r}=this.scale;e.eachContact((o,a,c,l)=>{let h=c.subarray(l,l+3),u=c.subarray(l+3,l+6),d=Py*i;this.points.add(...h),this.stubs.add(...h),this.stubs.add(h[0]+d*u[0],h[1]+d*u[1],h[2]+d*u[2]);let f=c[l+7];if(!Number.isFinite(f))return;let g=t.bodies[o]?.moves?1:-1,x=u.map(p=>p*g*Math.sign(f));this.arrows.add(h,x,Math.min(Math.abs(f)*r,Eh*this.scale.longest))}),e.eachJointLoad((o,a,c)=>{let l=a[c+7];if(!Number.isFinite(l))return;let h=Math.min(l*r,Eh*this.scale.longest);this.loads.add(a.subarray(c,c+3),a.subarray(c+3,c+6),h)});for(let o of[this.points,this.stubs,this.arrows,this.loads])o.show()}legend(){let t=r=>ni(r*this.scale.longest,3),e=`${t(1)} m`,i=`${ni(this.scale.full)} N is ${e} long, cut at ${t(Eh)} m`,n=[{colour:hc,text:"contact point and normal (towards the first body)"},{colour:Br,text:`force on a body that moves: ${i}`}];return this.view.run.joints>0&&n.push({colour:Or,text:`force of a joint on its first body: ${i}`}),n}};var dc=class{constructor(t){this.view=t,this.group=new Ht}update(){this.view.bodies.showEdges(!0)}hidden(){this.view.bodies.showEdges(!1)}legend(){return[]}};var Zt=class extends Error{};function on(s){return s instanceof Zt?s.message:`The viewer stopped because of a mistake of its own: ${s?.message??s}.`}var Ny=40,Fy=Ny/4;async function Sf(s,t){if(typeof DecompressionStream>"u")throw new Zt("This browser cannot unpack the frames (it has no DecompressionStream). A newer one can.");try{let e=new Blob([s]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(e).arrayBuffer())}catch{throw new Zt(`${t} cannot be unpacked: the data are damaged or were cut off.`)}}var By=new Float64Array(9);function fc(s,t,e){return je(Xe(t,e+3,By),s.center_of_mass).map((n,r)=>n+t[e+r])}var Mf=3;var pc=class{constructor(t){this.view=t,this.group=new Ht}update(){let{run:t,snapshot:e,bodies:i}=this.view,n=new Map;for(let a of t.moving){let c=e.islandOf(a);c!==null&&!n.has(c)&&n.set(c,a)}let r=Be("resting"),o=Be("alone");i.paint(a=>{if(e.kindOf(a)===null)return i.plainColour(a);if(e.kindOf(a)===Mf)return r;let c=e.islandOf(a);return c===null?o:lc[n.get(c)%lc.length]})}hidden(){this.view.bodies.paint(t=>this.view.bodies.plainColour(t))}legend(){return[{colour:Be("resting"),text:"at rest"},{colour:Be("alone"),text:"in no island"},{colour:lc[0],text:"one colour for each island"}]}};var Oy=.99;function Uy(s){let t=[...s].sort((n,r)=>n[0]-r[0]||n[1]-r[1]);if(t.length<3)return t;let e=(n,r,o)=>(r[0]-n[0])*(o[1]-n[1])-(r[1]-n[1])*(o[0]-n[0]),i=n=>{let r=[];for(let o of n){for(;r.length>1&&e(r.at(-2),r.at(-1),o)<=0;)r.pop();r.push(o)}return r.pop(),r};return[...i(t),...i(t.reverse())]}function ky(s){let t=new Map;return s.eachContact((e,i,n,r)=>{let o=`${e} ${i}`,a=Array.from(n.subarray(r,r+3)),c=Array.from(n.subarray(r+3,r+6));t.has(o)||t.set(o,[]);let l=t.get(o),h=l.find(({normal:u})=>u[0]*c[0]+u[1]*c[1]+u[2]*c[2]>Oy);h?h.points.push(a):l.push({normal:c,points:[a]})}),[...t.values()].flat()}var mc=class{constructor(t){this.view=t,this.group=new Ht,this.faces=new Cn,this.rims=new Cn;let e={color:bh,depthTest:!1,depthWrite:!1,transparent:!0},i=new Me(this.faces.geometry,new ci({...e,opacity:.45,side:He})),n=new Ue(this.rims.geometry,new ye(e));i.renderOrder=7,n.renderOrder=8,i.frustumCulled=n.frustumCulled=!1,this.group.add(i,n)}update(){this.faces.clear(),this.rims.clear();for(let{normal:t,points:e}of ky(this.view.snapshot)){let[i,n]=Bs(t),r=(c,l)=>c[0]*l[0]+c[1]*l[1]+c[2]*l[2],o=Uy(e.map((c,l)=>[r(i,c),r(n,c),l])).map(([,,c])=>e[c]);for(let c=1;c+1<o.length;c+=1)for(let l of[o[0],o[c],o[c+1]])this.faces.add(...l);let a=o.length===2?1:o.length;for(let c=0;o.length>1&&c<a;c+=1)this.rims.add(...o[c]),this.rims.add(...o[(c+1)%o.length])}this.faces.show(),this.rims.show()}legend(){return[{colour:bh,text:"contact manifold"}]}};var gc=new Float64Array(9),_c=new Float64Array(9);function xc(s,t,e,i){return Xe(t,e,gc),Xe(s.principal_axes,0,_c),je(_c,dh(gc,i))}function zy(s,t,e,i){return Xe(t,e,gc),Xe(s.principal_axes,0,_c),je(gc,dh(_c,i))}function yc(s,t,e,i){if(!s.principal_inertia)return null;let n=xc(s,t,e,i);return zy(s,t,e,n.map((r,o)=>r*s.principal_inertia[o]))}function Ah(s,t){return t.reduce((e,i,n)=>e+i*i*s.principal_inertia[n]/2,0)}var Gy=1.25,Vy=1.2,Hy=2e4,Wy=[3,4,5,6,10,11,12],Xy=.02,Th=Ur,vc=class{constructor(t,e){this.positions=new ee(new Float32Array(3*e),3);let i=n=>{let r=new Kt;r.setAttribute("position",this.positions),r.setDrawRange(0,0);let o=new ye({color:t,transparent:!0,opacity:n,depthTest:!1}),a=new bs(r,o);return a.frustumCulled=!1,a.renderOrder=6,a};this.past=i(1),this.all=i(.3),this.group=new Ht,this.group.add(this.all,this.past)}set(t,e){this.positions.setXYZ(t,...e)}show(t,e){this.past.geometry.setDrawRange(0,t),this.all.geometry.setDrawRange(0,e),this.positions.needsUpdate=!0}},Sc=class{constructor(t){this.view=t,this.group=new Ht,this.body=null,this.scan=null}chosenBody(){let{run:t,snapshot:e,followed:i}=this.view,n=o=>t.bodies[o].principal_inertia!==null&&e.place_of.has(o);if(i!==null)return i<t.bodies.length&&n(i)?i:null;if(this.body!==null)return this.body;let r=o=>Math.hypot(...e.rates.subarray(6*o+3,6*o+6));return t.moving.filter(n).reduce((o,a)=>o===null||r(a)>r(o)?a:o,null)}update(){let t=this.chosenBody();if(t!==this.body&&this.choose(t),this.body===null||!this.polhode)return;let{run:e,snapshot:i}=this.view,n=e.bodies[t],r=7*t,o=i.poses.subarray(r,r+7),a=i.centreOf(t);this.construction.position.set(...a);let[c,l,h,u]=n.principal_axes;this.in_body.quaternion.set(o[4],o[5],o[6],o[3]).multiply(new Ne(-l,-h,-u,c)),this.construction.scale.setScalar(this.scale||1);let d=Math.min(this.count,Math.floor(i.frame/this.stride)+1);this.polhode.show(d,this.count),this.herpolhode.show(d,this.count);let f=i.rates.subarray(6*t+3,6*t+6);this.placeEllipsoid(n,f,r),this.vector.clear(),this.vector.add(a,f,this.scale),this.vector.show()}placeEllipsoid(t,e,i){let{poses:n}=this.view.snapshot,r=Ah(t,xc(t,n,i+3,e)),o=t.principal_inertia.map(h=>Math.sqrt(2*r/h)),a=r>0&&o.every(Number.isFinite);if(this.ellipsoid.visible=this.plane.visible=a,!a)return;this.ellipsoid.scale.set(...o);let c=new D(...yc(t,n,i+3,e)),l=c.length();c.divideScalar(l),this.plane.position.copy(c).multiplyScalar(2*r/l),this.plane.quaternion.setFromUnitVectors(new D(0,0,1),c),this.plane.scale.setScalar(Vy*Math.max(...o))}choose(t){if(this.scan?.abort(),this.group.clear(),this.body=t,this.polhode=this.herpolhode=null,t===null)return;let{run:e}=this.view;this.stride=Math.ceil(e.times.length/Hy);let i=Math.ceil(e.times.length/this.stride);this.polhode=new vc(Si,i),this.herpolhode=new vc(Th,i),this.count=0,this.scale=0,this.in_body=new Ht,this.makeEllipsoid(),this.in_body.add(this.polhode.group,this.ellipsoid),this.construction=new Ht,this.construction.add(this.in_body,this.herpolhode.group,this.plane),this.group.add(this.construction,this.vector.group),this.scan=new AbortController,this.readCurves(e.bodies[t],e.moving.indexOf(t),this.scan.signal)}makeEllipsoid(){let t=new ws(1,32,20),e={transparent:!0,depthWrite:!1},i=new Me(t,new ci({...e,color:Si,opacity:.14})),n=new Ue(new mr(new ws(1,16,10)),new ye({...e,color:Si,opacity:.13}));this.ellipsoid=new Ht,this.ellipsoid.add(i,n),this.vector=new Qe(Si,Xy*this.view.radiusOf(this.body)),this.plane=new Me(new zn(1,64),new ci({...e,color:Th,opacity:.13,side:He}))}async readCurves(t,e,i){let{run:n,frames:r,radiusOf:o,requestDraw:a}=this.view,[,c,,l]=n.quanta,h=0,u=(d,f)=>{let g=Float64Array.from(f.subarray(0,4),S=>S*c);Fr(g,0);let x=Array.from(f.subarray(4),S=>S*l),p=xc(t,g,0,x),m=Ah(t,p);h=Math.max(h,...t.principal_inertia.map(S=>Math.sqrt(2*m/S))),this.polhode.set(this.count,p),this.herpolhode.set(this.count,x),this.count+=1,h>0&&(this.scale=Gy*o(this.body)/h)};await r.scan([e],Wy,this.stride,u,i,a)}legend(){let{run:t}=this.view;return this.body===null?[{colour:Si,text:"polhode: this body does not turn freely"}]:[{colour:Si,text:`polhode on the inertia ellipsoid of ${t.bodies[this.body].name}`},{colour:Th,text:"herpolhode on the invariable plane"}]}};var bf=2.2,wf=.022,Mc=class{constructor(t){this.view=t,this.group=new Ht,this.spin_scale=t.scaleOf("spin",bf),this.momentum_scale=t.scaleOf("momentum",bf),this.spins=new Qe(Si,wf*t.size),this.momenta=new Qe(Ur,wf*t.size),this.group.add(this.momenta.group,this.spins.group)}update(){let{run:t,snapshot:e}=this.view;this.spins.clear(),this.momenta.clear();let i=t.moving.map(n=>{let r=e.rates.subarray(6*n+3,6*n+6),o=yc(t.bodies[n],e.poses,7*n+3,r);return this.spin_scale.see(Math.hypot(...r)),o&&this.momentum_scale.see(Math.hypot(...o)),{origin:e.centreOf(n),spin:r,momentum:o}});for(let{origin:n,spin:r,momentum:o}of i)this.spins.add(n,r,this.spin_scale.factor),o&&this.momenta.add(n,o,this.momentum_scale.factor);this.spins.show(),this.momenta.show()}legend(){let t=(e,i,{full:n,longest:r})=>`${e}: ${ni(n)} ${i} is ${ni(r,3)} m long`;return[{colour:Si,text:t("angular velocity","rad/s",this.spin_scale)},{colour:Ur,text:t("angular momentum","kg m²/s",this.momentum_scale)}]}};var qy=3e5,Yy=[0,1,2,3,4,5,6],bc=class{constructor(t){this.view=t,this.group=new Ht,this.scan=null,this.segments=0}update(){let{run:t,snapshot:e}=this.view;if(t.moving.length===0||t.times.length===0)return;this.scan||this.begin();let i=Math.floor(e.frame/this.stride)*t.moving.length*2,n=this.segments*2;this.past.setDrawRange(0,Math.min(i,n)),this.all.setDrawRange(0,n),this.positions.needsUpdate=!0}begin(){let{run:t,frames:e,requestDraw:i}=this.view,n=t.moving.length;this.stride=Math.ceil(n*t.times.length/qy);let r=Math.ceil(t.times.length/this.stride)-1;this.positions=new ee(new Float32Array(6*n*r),3);let o=new ee(new Uint8Array(6*n*r),3,!0),a=t.moving.map(u=>new At(t.bodies[u].colour));for(let u=0;u<2*n*r;u+=1){let{r:d,g:f,b:g}=a[(u>>1)%n];o.setXYZ(u,d,f,g)}let c=u=>{let d=new Kt;d.setAttribute("position",this.positions),d.setAttribute("color",o);let f=new Ue(d,new ye({vertexColors:!0,transparent:!0,opacity:u}));return f.frustumCulled=!1,this.group.add(f),d};this.all=c(.22),this.past=c(1),this.scan=new AbortController;let l=t.moving.map((u,d)=>d),h=this.taker(t);e.scan(l,Yy,this.stride,h,this.scan.signal,i)}taker(t){let e=t.moving.length,[i,n]=t.quanta,r=new Float64Array(7),o=null;return(a,c)=>{let l=t.moving.map((h,u)=>{for(let d=0;d<7;d+=1)r[d]=c[d*e+u]*(d<3?i:n);return Fr(r,3),fc(t.bodies[h],r,0)});for(let h=0;o&&h<e;h+=1)this.positions.array.set(o[h],6*this.segments),this.positions.array.set(l[h],6*this.segments+3),this.segments+=1;o=l}}legend(){return[]}};var $y=2.5,Zy=.022,wc=class{constructor(t){this.view=t,this.scale=t.scaleOf("velocity",$y),this.arrows=new Qe(wh,Zy*t.size),this.group=this.arrows.group}update(){let{run:t,snapshot:e}=this.view,i=n=>e.rates.subarray(6*n,6*n+3);for(let n of t.moving)this.scale.see(Math.hypot(...i(n)));this.arrows.clear();for(let n of t.moving)this.arrows.add(e.centreOf(n),i(n),this.scale.factor);this.arrows.show()}legend(){let t=`velocity: ${ni(this.scale.full)} m/s is ${ni(this.scale.longest,3)} m long`;return[{colour:wh,text:t}]}};var Ch=[{name:"contacts",label:"Contacts, joints",of_contacts:!0,kind:uc},{name:"manifolds",label:"Manifolds",of_contacts:!0,kind:mc},{name:"velocities",label:"Velocities",of_contacts:!1,kind:wc},{name:"spins",label:"Spin, momentum",of_contacts:!1,kind:Mc},{name:"polhode",label:"Polhode",of_contacts:!1,kind:Sc},{name:"traces",label:"Traces",of_contacts:!1,kind:bc},{name:"boxes",label:"Boxes",of_contacts:!1,kind:oc},{name:"islands",label:"Islands, rest",of_contacts:!0,kind:pc},{name:"edges",label:"Edges",of_contacts:!1,kind:dc}];var Jy=[["Space","play or pause"],["← →","a frame back or on; with Shift ten"],["↑ ↓","faster, slower"],["Home End","to the start, to the end"],["[ ]","to the event before, to the next event"],["L","play in a loop"],["I","interpolate between frames"],["F","frame what is there now"],["H","look as at first"],["Esc","follow no body, show no numbers"],...Ch.map(({label:s},t)=>[String(t+1),s]),["?","this help"]];var HE=60*Math.PI,Et=s=>document.getElementById(s);function Ky(s,t){let e=s.trim();try{return Uint8Array.fromBase64?Uint8Array.fromBase64(e):Uint8Array.from(atob(e),i=>i.charCodeAt(0))}catch{throw new Zt(`${t} is not base64 text: the page is damaged or was cut off.`)}}function an(s,t,e){if(typeof s!="string")throw new Zt(`${e} is missing.`);let i=Ky(s,e);if(i.length%t.BYTES_PER_ELEMENT!==0)throw new Zt(`${e} has ${i.length} bytes, which is no whole number of values.`);return new t(i.buffer,i.byteOffset,i.length/t.BYTES_PER_ELEMENT)}function Ef(s){let t=document.getElementById(s);return t===null?null:t.textContent}function Af(s){let t=s.meshes.map(jy),e=Qy(s.runs[0],0,t.length,[]),{title:i,description:n,gravity:r}=s;return{title:i,description:n,gravity:r,look:{...Gi,...s.look},meshes:t,runs:[e]}}function jy(s,t){let e=`Mesh ${t}`,i=an(s.positions,Float32Array,`${e}: its vertices`),n=an(s.normals,Float32Array,`${e}: its normals`),r=an(s.indices,Uint32Array,`${e}: its triangles`),o=an(s.edges??"",Uint32Array,`${e}: its edges`),a=i.length/3,c=l=>l>=a;if(r.some(c)||o.some(c))throw new Zt(`${e} names a vertex that it lacks.`);return{positions:i,normals:n,indices:r,edges:o}}function Qy(s,t,e,i){let n=s.name||`run ${t+1}`,r=`The run “${n}”`,o=(s.bodies??[]).map((h,u)=>tv(h,u,e,r)),a=s.frames??{},c=an(a.times??"",Float64Array,`${r}: its times`);if(c.length!==(a.count??0))throw new Zt(`${r} tells of ${a.count} frames and gives ${c.length} times.`);if(c.some((h,u)=>!Number.isFinite(h)||u>0&&h<c[u-1]))throw new Zt(`${r} has frame times that are no numbers or run backwards.`);if((s.initial??[]).length!==o.length)throw new Zt(`${r} has ${o.length} bodies and ${(s.initial??[]).length} initial poses.`);let l=a.moving??[];if(l.some(h=>!(h>=0&&h<o.length)))throw new Zt(`${r} has frames of a body that it does not know.`);return c.length===0&&i.push(`${r} has no frames: nothing was computed. The start is shown.`),{index:t,name:n,outcome:s.outcome??"completed",duration:Number.isFinite(s.duration_s)?s.duration_s:c.at(-1)??0,bodies:o,joints:Array.isArray(s.joints)?s.joints.length:s.joints??0,fixtures:(s.fixtures??[]).map(h=>ev(h,o.length,e,r)),links:(s.links??[]).map((h,u)=>iv(h,u,o.length,r)),frame:s.frame??null,initial:Float64Array.from(s.initial.flat()),times:c,moving:l,contacts:!!a.contacts,quanta:[a.position_quantum_m,1/32767,a.velocity_quantum_m_s,a.spin_quantum_rad_s],chunks:nv(a.chunks??[],c.length,r),errors:rv(s.errors,l.length,r,i),series:sv(s.series??[],c.length,r,i),events:ov(s.events??[])}}function tv(s,t,e,i){let n=s.parts??[],r=n.find(o=>!(o.mesh>=0&&o.mesh<e));if(r)throw new Zt(`${i}: body ${t} has a part of mesh ${r.mesh}, which is missing.`);return{name:s.name||`body ${t}`,moves:!!s.moves,colour:s.colour??(s.moves?Mh[t%Mh.length]:null),label:s.label??"",opacity:s.opacity??1,mass_kg:s.mass_kg??null,center_of_mass:s.center_of_mass??[0,0,0],principal_inertia:s.principal_inertia_kg_m2??null,principal_axes:s.principal_axes??[1,0,0,0],parts:n,half_spaces:s.half_spaces??[],box:s.box??null}}function ev({body:s,part:t},e,i,n){if(!(s===null||s>=0&&s<e)||!(t?.mesh>=0&&t.mesh<i))throw new Zt(`${n}: something of a joint is of a body or a mesh that is missing.`);return{body:s,part:t}}function iv(s,t,e,i){let n=(s.ends??[]).map(({body:r,point:o})=>({body:r??null,point:o}));if(n.length!==2||n.some(({body:r})=>r!==null&&!(r>=0&&r<e)))throw new Zt(`${i}: link ${t} does not have two ends of bodies that it knows.`);return{kind:s.kind,ends:n,radius_m:s.radius_m,length_m:s.length_m}}function nv(s,t,e){let i=0;for(let n of s){if(n.first!==i||!(n.count>0))throw new Zt(`${e}: its frames do not follow one another (frame ${i} is missing).`);i+=n.count}if(i!==t)throw new Zt(`${e} tells of ${t} frames and holds ${i}.`);return s}function sv(s,t,e,i){let n=[];for(let r of s){let o=`${e}: the series “${r.group} ${r.name}”`,a=an(r.values,Float64Array,o);a.length!==t?i.push(`${o} has ${a.length} values for ${t} frames and is left out.`):t>0&&!a.some(Number.isFinite)?i.push(`${o} has no numbers and is left out.`):n.push({group:r.group,name:r.name,unit:r.unit??"",values:a})}return n}function rv(s,t,e,i){if(!s)return null;let n=an(s.times,Float64Array,`${e}: the times of its errors`),r=an(s.values,Float32Array,`${e}: its errors`);return r.length===2*t*n.length?{times:n,values:r}:(i.push(`${e} has ${r.length} errors at ${n.length} times: they are left out.`),null)}function ov(s){return s.filter(t=>Number.isFinite(t.t)).map(t=>({t:t.t,kind:t.kind??"event",bodies:t.bodies??[],text:t.text??""})).sort((t,e)=>t.t-e.t)}function Rh(s,t){let e=document.getElementById(s)?.textContent;if(!e)throw new Zt(`The page does not hold ${t}: it was cut off before its end. Get it again, or write it by \`polhode play\`.`);let i=new Uint8Array(Math.floor(e.length*7/8)),n=0,r=0,o=0;for(let a=0;a<e.length;a+=1)n=n<<7|e.charCodeAt(a)&127,r+=7,r>=8&&(r-=8,i[o]=n>>r,o+=1,n&=(1<<r)-1);return i}async function kr(s,t){return new TextDecoder().decode(await Sf(Rh(s,t),t))}var Ph="scene=";async function Tf(s,t){let e=new Blob([s]).stream().pipeThrough(t);return new Uint8Array(await new Response(e).arrayBuffer())}function av(s){let t="";for(let e=0;e<s.length;e+=32768)t+=String.fromCharCode(...s.subarray(e,e+32768));return btoa(t).replaceAll("+","-").replaceAll("/","_").replaceAll("=","")}function cv(s){return Uint8Array.from(atob(s.replaceAll("-","+").replaceAll("_","/")),t=>t.charCodeAt(0))}async function Cf(s){let t=new TextEncoder().encode(s);return`#${Ph}${av(await Tf(t,new CompressionStream("deflate")))}`}async function Ih(s){if(!s.startsWith(`#${Ph}`))return null;try{let t=await Tf(cv(s.slice(Ph.length+1)),new DecompressionStream("deflate"));return new TextDecoder("utf-8",{fatal:!0}).decode(t)}catch{throw new Zt("The scene in the address cannot be read: the address was cut off or changed on its way. Ask for it again, as a whole; many programs break long lines.")}}function Rf(s){let t=Math.min(3,devicePixelRatio||1),{clientWidth:e,clientHeight:i}=s;(s.width!==Math.round(e*t)||s.height!==Math.round(i*t))&&(s.width=Math.round(e*t),s.height=Math.round(i*t));let n=s.getContext("2d");return n.setTransform(t,0,0,t,0,0),{pen:n,width:e,height:i}}function ae(s,t=""){return t?`${ni(s,3)} ${t}`:ni(s,3)}function Rn(s){return Number.isFinite(s)?s!==0&&Math.abs(s)<.001?ni(s,3):`${Number((100*s).toPrecision(3))} %`:"–"}var lv=1e-15,hv=1e-11,uv=.01,Ec=class{constructor(t){this.root=t,this.canvas=t.querySelector("canvas"),this.words=t.querySelector("p"),this.series=new Map}begin(t,e,i){this.series.set(t,{label:e,text:i,points:[]}),this.root.hidden=!1}drop(t){this.series.delete(t),this.root.hidden=this.series.size===0}clear(){for(let t of this.series.values())t.points.length=0}add(t,e,i){let{points:n}=this.series.get(t);for(;n.length>0&&n.at(-1)[0]>=e;)n.pop();n.push([e,i])}lastTime(t){return this.series.get(t)?.points.at(-1)?.[0]??-1/0}cut(t){for(let{points:e}of this.series.values())for(;e.length>0&&e.at(-1)[0]>t;)e.pop()}draw(t,e){if(this.root.hidden)return;let{pen:i,width:n,height:r}=Rf(this.canvas);i.clearRect(0,0,n,r);let o=[...this.series.values()].flatMap(({points:p})=>p),a=Math.max(t,...o.slice(-1).map(([p])=>p),1e-9),c=o.map(([,p])=>p).filter(p=>p>lv),l=Math.ceil(Math.log10(Math.max(...c,1e-12))+.05),h=Math.min(l-2,Math.floor(Math.log10(Math.min(...c,.001)))),u=52,d=r-18,f=p=>u+p/a*(n-u-6),g=p=>6+(l-Math.log10(Math.max(p,10**h)))/(l-h)*(d-6);i.font="11px system-ui, sans-serif",i.fillStyle=Be("quiet"),i.strokeStyle=Be("rule"),i.textAlign="right",i.textBaseline="middle";let x=Math.max(1,Math.ceil((l-h)/5));for(let p=l;p>=h;p-=x){let m=g(10**p);i.fillText(`1e${p} m`,u-4,m),i.beginPath(),i.moveTo(u,m),i.lineTo(n-6,m),i.stroke()}i.textBaseline="alphabetic",i.fillText(`${ae(a)} s`,n-6,r-4),i.textAlign="left",i.fillText("0",u,r-4);for(let{text:p,points:m}of this.series.values())i.strokeStyle=p,i.lineWidth=1.6,i.beginPath(),m.forEach(([S,C],b)=>b===0?i.moveTo(f(S),g(C)):i.lineTo(f(S),g(C))),i.stroke();this.words.textContent=[...this.series.values()].map(p=>dv(p,t,e)).join(" ")}};function dv({label:s,points:t},e,i){let n=t.findLast(([a])=>a<=e+1e-9)??t.at(-1);if(!n)return`${s}: not computed yet.`;let r=s.startsWith("Second")?fv(t,i):null,o=r?` They part by a factor of ten in ${ae(Math.LN10/r,"s")} (Lyapunov time ${ae(1/r,"s")}).`:"";return`${s}: ${ae(n[1],"m")} away.${o}`}function fv(s,t){let e=s.filter(([,l])=>l>hv*t&&l<uv*t);if(e.length<8)return null;let i=l=>e.reduce((h,u)=>h+(l===0?u[0]:Math.log(u[1])),0)/e.length,[n,r]=[i(0),i(1)],o=e.reduce((l,[h,u])=>l+(h-n)*(Math.log(u)-r),0),a=e.reduce((l,[h])=>l+(h-n)**2,0),c=o/a;return c*(e.at(-1)[0]-e[0][0])>2?c:null}var Ac=class{constructor(t,{typed:e,changed:i}){this.area=t.querySelector("textarea"),this.gutter=t.querySelector(".gutter"),this.list=t.querySelector(".faults"),this.marks=new Map;let n=null;this.setting=!1,this.area.addEventListener("input",()=>{this.setting||(this.number(),e(),clearTimeout(n),n=setTimeout(i,350))}),this.area.addEventListener("scroll",()=>{this.gutter.scrollTop=this.area.scrollTop})}get text(){return this.area.value}set text(t){if(t===this.area.value)return;let e=document.activeElement;this.area.focus({preventScroll:!0}),this.area.select();let i=!1;this.setting=!0;try{i=t!==""&&this.area.value!==""&&document.execCommand("insertText",!1,t)}catch{i=!1}(!i||this.area.value!==t)&&(this.area.value=t),this.setting=!1,this.area.setSelectionRange(0,0),this.area.scrollTop=0,e!==this.area&&(this.area.blur(),e?.focus?.({preventScroll:!0})),this.number()}number(){let t=this.area.value.split(`
`).length,e=[];for(let i=1;i<=t;i+=1){let n=document.createElement("span");n.textContent=i;let r=this.marks.get(i);r&&(n.className="refused",n.title=r),e.push(n)}this.gutter.replaceChildren(...e),this.gutter.scrollTop=this.area.scrollTop}refuse(t,e){this.marks=new Map(e.map(({line:n,words:r})=>[n,r]));let i=e.map(({line:n,column:r,key:o,words:a})=>{let c=document.createElement("button");return c.type="button",c.textContent=`line ${n}: ${o?`${o}: `:""}${a}`,c.addEventListener("click",()=>this.goTo(n,r)),c});if(i.length<2){let n=document.createElement("p");n.textContent=t,i.push(n)}this.list.replaceChildren(...i),this.list.hidden=!1,this.area.setAttribute("aria-invalid","true"),this.number()}accept(){this.marks.clear(),this.list.hidden=!0,this.list.replaceChildren(),this.area.removeAttribute("aria-invalid"),this.number()}goTo(t,e){let i=this.area.value.split(`
`),n=i.slice(0,t-1).reduce((r,o)=>r+o.length+1,0)+Math.max(0,e-1);this.area.focus(),this.area.setSelectionRange(n,n+Math.max(1,(i[t-1]?.length??1)-e+1)),this.area.scrollTop=Math.max(0,(t-4)*18)}};var pv=[["kinetic","Kinetic","#3b7dd8"],["potential","Potential","#3f9d6c"],["friction","Lost to friction","#e07b39"],["impacts","Lost in impacts","#8a6bd1"],["damping","Lost to damping","#b8962e"],["rest","Lost coming to rest","#7c8b99"],["projection","Lost by projection","#c94f6d"],["numerical","Numerical loss","#d8334a"]],Tc=class{constructor(t){this.root=t,this.lowest=1/0,this.stack=document.createElement("div"),this.stack.className="stack",this.table=document.createElement("table"),this.sum=document.createElement("p"),t.append(this.stack,this.table,this.sum),this.rows=new Map(pv.map(([e,i,n])=>{let r=this.table.insertRow();r.dataset.name=e;let o=r.insertCell(),a=document.createElement("i");a.style.background=n,o.append(a,i);let c=r.insertCell();c.className="bar-cell";let l=document.createElement("b");l.style.background=n,c.append(l);let h=r.insertCell();h.className="value";let u=document.createElement("span");return u.style.background=n,this.stack.append(u),[e,{row:r,fill:l,value:h,part:u}]}))}clear(){this.lowest=1/0}show(t){this.lowest=Math.min(this.lowest,t.potential_j,0);let e={kinetic:t.kinetic_j,potential:t.potential_j,...t.lost},i={...e,potential:t.potential_j-this.lowest},n=Math.max(t.scale_j,1e-300),r=Math.max(Object.values(i).reduce((a,c)=>a+Math.abs(c),0),1e-300);for(let[a,{row:c,fill:l,value:h,part:u}]of this.rows){let d=i[a],f=Math.min(1,Math.abs(d)/r);u.style.flexGrow=f,l.style.width=`${100*f}%`,l.classList.toggle("gain",d<0),h.textContent=ae(e[a],"J");let g=!["kinetic","potential","numerical","friction","impacts"].includes(a);c.hidden=g&&e[a]===0,a==="numerical"&&(h.title=`${Rn(e.numerical/n)} of the largest energy`,c.classList.toggle("grave",Math.abs(e.numerical/n)>.001))}let o=t.external_j===0?"":` and ${ae(t.external_j,"J")} of work`;this.sum.textContent=`They add up to the ${ae(t.initial_j,"J")} of the start${o}, to ${t.closure_relative.toExponential(0)} of the largest. Numerical loss: ${Rn(t.lost.numerical/n)} of it.`}};var Cc=class{constructor(t){this.width=7*t.bodies.length,this.duration=t.duration_s,this.times=[],this.frames=[],this.now=0,this.wanted=0,this.beyond=!1,this.ended=!1,this.done=!1,this.held=[],this.steps=0,this.used_ms=0}get first(){return this.times[0]??0}get end(){return this.times.at(-1)??0}add({times:t,poses:e,ended:i,now:n,held:r,steps:o,used_ms:a}){if(t.forEach((c,l)=>{this.times.length>0&&c<this.end||(c===this.end&&this.times.length>0&&(this.times.pop(),this.frames.pop()),this.times.push(c),this.frames.push(e.subarray(l*this.width,(l+1)*this.width)))}),Object.assign(this,{ended:i,now:n,held:r,steps:o,used_ms:a}),this.times.length*this.width*8>268435456){let c=this.times.length>>1;this.times.splice(0,c),this.frames.splice(0,c)}}cut(t,e){let i=this.times.findLastIndex(n=>n<t)+1;this.times.length=i,this.frames.length=i,this.times.push(t),this.frames.push(e),this.now=t,this.ended=!1,this.done=!1,this.wanted=t}at(t,e){let{times:i,frames:n,width:r}=this;if(i.length===0)return;let o=0,a=i.length;for(;a-o>1;){let d=o+a>>1;i[d]<=t?o=d:a=d}let c=(i[o+1]??i[o])-i[o],l=c>0?Math.min(1,Math.max(0,(t-i[o])/c)):0,h=n[o];if(l===0){e.set(h);return}let u=n[o+1];for(let d=0;d<r;d+=7){for(let p=0;p<3;p+=1)e[d+p]=h[d+p]+l*(u[d+p]-h[d+p]);let f=0;for(let p=3;p<7;p+=1)f+=h[d+p]*u[d+p];let g=f<0?-1:1,x=0;for(let p=3;p<7;p+=1)e[d+p]=h[d+p]+l*(g*u[d+p]-h[d+p]),x+=e[d+p]**2;x=Math.sqrt(x)||1;for(let p=3;p<7;p+=1)e[d+p]/=x}}distance(t,e,i){let n=new Float64Array(this.width),r=new Float64Array(t.width);this.at(e,n),t.at(e,r);let o=0;for(let a of i){let c=7*a;o=Math.max(o,Math.hypot(n[c]-r[c],n[c+1]-r[c+1],n[c+2]-r[c+2]))}return o}};var mv=1e4,gv=1500,cn=class extends Error{constructor({message:t,places:e,grave:i}){super(t),this.places=e??[],this.grave=!!i}},Rc=class{constructor(t,e,i){this.source=t,this.module=e,this.tell=i,this.files=new Map,this.begin()}begin(){this.url=URL.createObjectURL(new Blob([this.source],{type:"text/javascript"})),this.worker=new Worker(this.url),this.epoch=0,this.asked_epoch=0,this.early=new Map,this.id=0,this.open=new Map,this.track=null,this.heard=performance.now(),this.worker.onmessage=({data:t})=>this.hear(t),this.worker.onerror=t=>{t.preventDefault(),this.failAll(new cn({message:`the engine could not be started: ${t.message||"the worker was refused"}`,grave:!0}))},this.started=this.ask({do:"start",module:this.module}).then(()=>Promise.all([...this.files].map(([t,e])=>this.ask({do:"file",name:t,bytes:e})))),this.started.catch(()=>{})}restart(){this.end(),this.begin()}end(){this.worker.terminate(),URL.revokeObjectURL(this.url),this.failAll(new cn({message:"the engine was stopped"}))}failAll(t){for(let{refuse:e}of this.open.values())e(t);this.open.clear()}ask(t){this.id+=1;let{id:e}=this;return this.open.size===0&&(this.heard=performance.now()),new Promise((i,n)=>{this.open.set(e,{answer:i,refuse:n}),this.worker.postMessage({...t,id:e})})}send(t){this.worker.postMessage(t)}isStuck(){return(this.open.size>0||this.track&&this.track.wanted>this.track.now&&!this.track.done)&&performance.now()-this.heard>mv}hear(t){if(this.heard=performance.now(),t.did==="frames"){t.epoch===this.epoch?this.track?.add(t):t.epoch>this.epoch&&this.early.set(t.epoch,t);return}if(t.did==="cut"){t.epoch===this.epoch&&this.track?.cut(t.t,t.poses);return}if(t.did==="mark"){t.epoch===this.epoch&&this.tell.mark?.(t);return}if(t.did==="broke"){t.epoch===this.epoch&&(this.track&&(this.track.done=!0),this.tell.broke?.(new cn(t.fault),this));return}let e=this.open.get(t.id);if(e){if(t.did==="begun"){e.begun=!0;return}this.open.delete(t.id),t.did==="fault"?e.refuse(new cn(t.fault)):e.answer(t)}}addFile(t,e){return this.files.set(t,e),this.ask({do:"file",name:t,bytes:e})}async load(t,e,{shift:i=0,marks:n=[]}={}){this.asked_epoch+=1;let r=this.asked_epoch,o=this.ask({do:"load",text:t,changes:e.join(`
`),epoch:r,shift:i,marks:n}),a=this.open.get(this.id),c=new Promise(f=>setTimeout(f,gv,"waited"));if(await Promise.race([o.catch(()=>null),c])==="waited"&&!a.begun)return this.restart(),await this.started,this.load(t,e,{shift:i,marks:n});let h=await o,u=JSON.parse(h.show);this.epoch=r,this.track=new Cc(u.runs[0]);let d=this.early.get(r);return this.early.clear(),d&&this.track.add(d),{show:u,surface:h.surface,shifted:h.shifted}}goTo(t,e){!this.track||this.track.wanted>=t&&this.track.beyond===e||(this.track.now>=this.track.wanted&&(this.heard=performance.now()),this.track.wanted=t,this.track.beyond=e,this.send({do:"ahead",until:t,beyond:e}))}act(t,e,i){return this.track&&(this.track.done=!1,this.track.wanted=i),this.ask({do:"act",name:t,args:e,at:i})}};var Pf=16*1024*1024;function _v(s){return`format = 1
name = "${s.replace(/\.[^.]*$/,"").replaceAll('"',"")}"
duration = 3.0

[materials.solid]
friction = 0.5
restitution = 0.2

[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
position = [0, 0, -1]
material = "solid"

[[bodies]]
name = "body"
shape.convex.file = "${s.replaceAll('"',"")}"
density = 1000.0
position = [0, 0, 0]
material = "solid"
`}var xv=["stl","obj","off","ply"],Nf=["urdf","xml","mjcf","xacro"],yv=["csv"],If="a scene (.toml), a robot (.urdf, .xml, .mjcf) with its meshes, a table of boxes (.csv), or a mesh (.stl, .obj, .off, .ply)",Ff=s=>(s.match(/\.([^.]*)$/)?.[1]??"").toLowerCase(),Dh=(s,t)=>s.includes(`"${t}"`)||s.includes(`/${t}"`),Os=null;async function vv(s,t){let e={texts:[],named:[],stands:[]};for(let i of t){let n=Ff(i.name);if(i.size>Pf){s.notice(`${i.name} has ${ae(i.size/1e6,"MB")}, and the page takes files of up to ${Pf/1024/1024} MB. Run it by the program: polhode run FILE, polhode view FILE. Your text is as it was.`);continue}let r=new Uint8Array(await i.arrayBuffer()),{name:o}=i;if(xv.includes(n)){e.named.push({name:o,bytes:r});continue}let a;try{a=new TextDecoder("utf-8",{fatal:!0}).decode(r)}catch{s.notice(`${o} is no scene: it is not text. Drop ${If}.`);continue}Nf.includes(n)||yv.includes(n)?e.stands.push({name:o,bytes:r,text:a}):n==="toml"||/^\s*format\s*=/m.test(a)?e.texts.push(a):s.notice(`${o} is no scene: no line \`format = 1\` is in it. Drop ${If}.`)}return e}async function Df(s,t){let{name:e}=t;try{let i=await s.sceneOf(e);Os=null,await s.take(i)}catch(i){Os=Nf.includes(Ff(e))?t:null;let n=Os?" Where it misses a file, drop that too.":"";s.notice(`${e} could not be read: ${i?.message??i}${n} Your text is kept.`)}}async function Lf(s,t){try{let{texts:e,named:i,stands:n}=await vv(s,t),r=[...i,...n].find(({name:l},h,u)=>u.findIndex(d=>d.name===l)<h);if(r){s.notice(`Two files are called ${r.name}, and the page knows no folders: give one another name, or use polhode play SCENE.`);return}for(let{name:l,bytes:h}of[...i,...n])await s.addFile(l,h);let o=s.editor.text,a=n.find(({name:l})=>!n.some(h=>h.name!==l&&Dh(h.text,l))),c=[...i,...n].map(({name:l})=>l);e.length>0?await s.take(e.at(-1)):c.some(l=>Dh(o,l))?await s.run():a?await Df(s,a):Os&&c.some(l=>Dh(Os.text,l))?await Df(s,Os):i.length>0&&await s.take(_v(i.at(-1).name))}catch(e){s.notice(`The files could not be read: ${e?.message??e}. Your text is kept.`)}}function Bf(s){let t=Et("app"),e=Et("file");Et("open").addEventListener("click",()=>e.click()),e.addEventListener("change",()=>{Lf(s,[...e.files]),e.value=""}),document.addEventListener("dragover",i=>{i.preventDefault(),t.classList.add("dropping")}),document.addEventListener("dragleave",i=>{i.relatedTarget||t.classList.remove("dropping")}),document.addEventListener("drop",i=>{i.preventDefault(),t.classList.remove("dropping"),i.dataTransfer.files.length>0&&Lf(s,i.dataTransfer.files)})}function Of(s,t){let e=URL.createObjectURL(new Blob([s],{type:"application/toml"})),i=document.createElement("a");i.href=e,i.download=t,i.click(),URL.revokeObjectURL(e)}var Pn=[.01,.02,.05,.1,.2,.5,1,2,5,10],Sv=[["","scene’s"],["accurate","accurate"],["stepped","stepped"],["fast","fast"],["thesis","thesis"]],Mv=[["","scene’s"],["propagation","propagation"],["simultaneous","simultaneous"],["reflection","reflection"],["poisson","poisson"],["energetic","energetic"],["pulse","pulse"]],bv=[["Space","run or pause"],["R","from the start"],["← →","back or on by a hundredth of what was run; with Shift a tenth"],["↑ ↓","faster, slower"],["N","look at the next body: the forces on it"],["P","push the body that is looked at"],["T","ghost of truth"],["C","second copy"],["F","fit all into the picture"],["H","look as at first"],["E","to the text"],["Esc","look at no body; out of the text"],["?","this help"]];function kf(s){for(let[t,e]of bv){let i=s.insertRow();i.insertCell().textContent=t,i.insertCell().textContent=e}}function Lh(s,t){Et(s).replaceChildren(...t.map(([e,i])=>new Option(i,e)))}function Uf(s,t){let e=Et(s),i=e.parentElement.querySelector("output"),n=null;return e.addEventListener("input",()=>{i.textContent=ae(Number(e.value)),clearTimeout(n),n=setTimeout(()=>t(Number(e.value)),80)}),r=>{document.activeElement===e&&n!==null&&e.matches(":active")||(r<=Number(e.max)||(e.max=String(Math.ceil(r))),e.value=String(r),i.textContent=ae(r))}}function zf(s){let t=(r,o)=>Et(r).addEventListener("click",o);Lh("tier",Sv),Lh("law",Mv),Lh("speed",Pn.map(r=>[r,`${r}×`])),Et("tier").addEventListener("change",()=>s.run()),Et("law").addEventListener("change",()=>s.run()),Et("speed").addEventListener("change",()=>s.speed=Number(Et("speed").value)),t("play",()=>s.toggle()),t("restart",()=>s.restart()),t("truth",()=>s.setCopy("truth",Et("truth").getAttribute("aria-pressed")!=="true")),t("twin",()=>s.setCopy("twin",Et("twin").getAttribute("aria-pressed")!=="true")),t("push",()=>s.push()),t("let-go",()=>s.select(null)),t("save",()=>s.saveText()),t("link",()=>s.link()),t("help-button",()=>Et("help").showModal()),t("licences",wv);let e=Et("scrub");e.addEventListener("input",()=>{s.pause(),s.seek(Number(e.value))}),Ev(s),Av(s);let i=Uf("friction",r=>s.setFriction(r)),n=Uf("restitution",r=>s.setRestitution(r));return{showSurface([r,o]){i(r),n(o)},showSpeed(r){Et("speed").value=String(r)},showTime({time:r,playing:o},a){let c=Math.max(a.end,Math.min(a.duration,a.end+1e-9));e.min=String(a.first),e.max=String(c),e.matches(":active")||(e.value=String(r)),e.setAttribute("aria-valuetext",`${ae(r)} s of ${ae(a.duration)} s`),Et("time").textContent=Sh(r,a.duration),Et("play").classList.toggle("playing",o),Et("play").setAttribute("aria-label",o?"Pause":"Run")},showPace(r){if(!(r.used_ms>0))return;let o=r.steps/r.used_ms*1e3,a=r.now/(r.used_ms/1e3);Et("pace").textContent=`${ae(r.steps)} steps, ${ae(o)} steps/s in the worker: ${ae(a)} s of motion in a second.`}}}async function wv(){let s=Et("licence-texts");s.textContent=await kr("polhode-licences","The licences").catch(on),s.hidden=!1,s.scrollIntoView()}function Ev(s){let t=[["Home","home"],["Fit","fit"],["Front","front"],["Side","side"],["Top","top"]].map(([e,i])=>{let n=document.createElement("button");return n.textContent=e,n.title=`Look from: ${i}`,n.addEventListener("click",()=>s.picture.fit(i)),n});Et("cameras").replaceChildren(...t)}function Av(s){let t=s.given.examples??[],e=Et("examples");e.hidden=t.length===0,e.append(...t.map(({name:i,title:n})=>new Option(n||i,i))),e.addEventListener("change",()=>{let i=t.find(({name:n})=>n===e.value);e.value="",i&&s.take(i.text)})}function Gf(s){let t=o=>{s.pause();let{track:a}=s.engine;s.seek(s.time+o*(a.end-a.first))},e=o=>{let a=Math.min(Pn.length-1,Math.max(0,Pn.indexOf(s.speed)+o));s.speed=Pn[a],Et("speed").value=String(Pn[a])},i=o=>Et(o).click(),r={" ":()=>s.toggle(),r:()=>s.restart(),ArrowLeft:o=>t(o.shiftKey?-.1:-.01),ArrowRight:o=>t(o.shiftKey?.1:.01),ArrowUp:()=>e(1),ArrowDown:()=>e(-1),n:()=>{let{moving:o}=s.picture.run,a=o.indexOf(s.picture.selected);o.length>0&&s.pick(o[(a+1)%o.length])},p:()=>s.push(),t:()=>i("truth"),c:()=>i("twin"),f:()=>s.picture.fit("fit"),h:()=>s.picture.fit("home"),e:()=>s.editor.area.focus(),Escape:()=>s.select(null),"?":()=>Et("help").showModal()};document.addEventListener("keydown",o=>{if(o.ctrlKey||o.metaKey||o.altKey||!s.engine?.track)return;if(o.key==="Escape"&&o.target===s.editor.area){s.editor.area.blur();return}if(o.target.closest?.("select, input, textarea, dialog"))return;let a=r[o.key]??r[o.key.toLowerCase()];a&&(o.preventDefault(),a(o))}),document.addEventListener("keyup",o=>{o.key===" "&&o.target.closest?.("button")&&o.preventDefault()})}var Tv=.01,Pc=class{constructor(t){this.promise=t.querySelector("#promise"),this.horizon=t.querySelector("#horizon"),this.hash=t.querySelector("#hash"),this.native=null,this.marks=0,this.differs=null}begin(t){this.native=t,this.marks=0,this.differs=null}mark({hash:t,native:e,t:i}){t===e?this.marks+=1:this.differs??=i}show(t,e){let i=Object.entries(t.limits).reduce((l,h)=>h[1]>(l?.[1]??-1)?h:l,null);this.promise.className=t.kept?"light good":"light bad",this.promise.querySelector("span").textContent=t.kept?`Promise of ${t.tier} kept${i&&i[1]>0?`: ${i[0]} at ${Rn(i[1])} of its limit`:""}`:`Promise of ${t.tier} broken: ${t.broken[0]?.warning??t.warnings[0]??"see the report"}`;let{horizon_s:n,estimated_error:r}=t,o=n!==null&&e>n,a=r!==null,c=a&&r<Tv;this.horizon.className=o||a&&!c?"light warn":a?"light good":"light off",this.horizon.querySelector("span").textContent=o?`Beyond the horizon at ${ae(n,"s")}: rounding alone decides; this is one of many outcomes`:r===null?"Error not estimated yet":`Estimated error ${ae(r)} of a body${n===null?"; no horizon met":`; horizon at ${ae(n,"s")}`}`,this.showHash(t)}showHash(t){let{native:e}=this,i="light off",n;t.untouched?e?this.differs!==null?(i="light bad",n=`differs from the native program, first before t = ${ae(this.differs,"s")}`):t.ended&&e.hash===t.hash?(i="light good",n=`native ${e.hash}: the same bits, to the end`):t.ended&&e.ended?(i="light bad",n=`native ${e.hash}: other bits`):this.marks>0?(i="light good",n=`the same bits as the native program so far (${this.marks} of ${e.marks.length} places)`):n="not compared with the native program yet":n="Compare it with `polhode play SCENE --hash`":n="You have acted: the run is no longer that of the scene alone",this.hash.className=i,this.hash.querySelector("span").textContent=`Hash ${t.hash} – ${n}`}};var Vf=6,Hf=12,Cv=150,Rv=6e4;function Wf(s,t){let e=s.index.count/3;return e>Cv&&e*t>Rv}function Pv(s){s.computeBoundingBox();let{min:t,max:e}=s.boundingBox,i=Math.max(e.x-t.x,e.y-t.y,e.z-t.z)/Vf,n=s.getAttribute("position"),r=new Map;return Uint32Array.from({length:n.count},(o,a)=>{let l=[n.getX(a)-t.x,n.getY(a)-t.y,n.getZ(a)-t.z].map(h=>Math.min(Vf-1,Math.floor(h/i))).join(" ");return r.has(l)||r.set(l,r.size),r.get(l)})}function Iv(s,t,e){let i=new Float32Array(3*e),n=new Float32Array(e);return t.forEach((r,o)=>{for(let a=0;a<3;a+=1)i[3*r+a]+=s.array[3*o+a];n[r]+=1}),i.map((r,o)=>r/n[Math.floor(o/3)])}function Xf(s){let t=Pv(s),e=t.reduce((o,a)=>Math.max(o,a+1),0),i=[];for(let o=0;o<s.index.count;o+=3){let[a,c,l]=[0,1,2].map(h=>t[s.index.array[o+h]]);a!==c&&c!==l&&l!==a&&i.push(a,c,l)}let n=new Kt,r=o=>new ee(Iv(s.getAttribute(o),t,e),3);return n.setAttribute("position",r("position")),n.setAttribute("normal",r("normal")),n.setIndex(i),n}var Dv=[0,0,0,1,0,0,0],Lv=.3;function qf(s){let t=new Kt;if(t.setAttribute("position",new ee(s.positions,3)),t.setAttribute("normal",new ee(s.normals,3)),t.setIndex(new ee(s.indices,1)),s.edges.length===0)return{faces:t,edges:null};let e=new Kt;return e.setAttribute("position",t.getAttribute("position")),e.setIndex(new ee(s.edges,1)),{faces:t,edges:e}}function Nv(s){return new xi().setFromBufferAttribute(s.getAttribute("position")).getCenter(new D)}function Fv(s,t){let e=new Gn({polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});if(!t)return e;let i=Nv(s);return e.onBeforeCompile=n=>{n.uniforms.middle={value:i},n.vertexShader=n.vertexShader.replace("#include <common>",`#include <common>
uniform vec3 middle;
varying vec3 inBody;`).replace("#include <begin_vertex>",`#include <begin_vertex>
inBody = position - middle;`),n.fragmentShader=n.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 inBody;`).replace("#include <color_fragment>",`#include <color_fragment>
        vec3 side = clamp(inBody / max(fwidth(inBody), vec3(1e-30)), -1.0, 1.0);
        diffuseColor.rgb *= 0.89 + 0.11 * side.x * side.y * side.z;`)},e}function Bv(s,t){let e=Xe(s.orientation,0,new Float64Array(9));for(let i=0;i<9;i+=1)e[i]*=s.scale[i%3];return t.computeBoundingSphere(),{matrix:e,origin:s.position,radius:t.boundingSphere.radius*Math.max(...s.scale)}}var Nh=class{constructor(t,e,i,n){this.members=t;let r=Fv(e.faces,e.edges===null),o=i.ghost?Lv*n:n;o<1&&Object.assign(r,{transparent:!0,opacity:o,depthWrite:!1}),this.colours=new Float32Array(3*t.length).fill(1),this.fine=this.makeMesh(e.faces,r,i);let a=Wf(e.faces,t.length);if(this.coarse=a?this.makeMesh(Xf(e.faces),r,i):null,this.lines=null,!e.edges)return;let c=new ye({transparent:!0,opacity:Math.min(.75,o)});this.lines=Ns(e.edges,c,t.length,this.fine.mesh.instanceMatrix)}makeMesh(t,e,i){let n=Jn(t,e,this.members.length);return n.castShadow=i.shadows&&!i.ghost&&!e.transparent,n.receiveShadow=i.shadows,n.instanceColor=new Ci(new Float32Array(this.colours.length),3),n.instanceColor.setUsage(vi),{mesh:n,shown:[]}}objects(){return[this.fine.mesh,this.coarse?.mesh,this.lines].filter(Boolean)}update(t,e){let i=[this.fine,this.coarse].filter(Boolean);for(let r of i)r.shown.length=0;let n=new Float64Array(9);this.members.forEach(({body:r,matrix:o,origin:a,radius:c},l)=>{let[h,u]=r===null?[Dv,0]:[t,7*r];Xe(h,u+3,n);let d=je(n,a);for(let m=0;m<3;m+=1)d[m]+=h[u+m];let g=this.coarse&&e&&c*e.pixels/Ov(d,e.place)<Hf?this.coarse:this.fine,x=g.shown.push(l)-1,p=m=>je(n,[o[m],o[3+m],o[6+m]]);rn(g.mesh.instanceMatrix.array,x,p(0),p(1),p(2),d);for(let m=0;m<3;m+=1)g.mesh.instanceColor.array[3*x+m]=this.colours[3*l+m]});for(let{mesh:r,shown:o}of i)r.count=o.length,r.instanceMatrix.needsUpdate=!0,r.instanceColor.needsUpdate=!0;this.lines&&(this.lines.count=this.fine.shown.length)}pick(t){let e=null;for(let{mesh:i,shown:n}of[this.fine,this.coarse].filter(Boolean)){i.boundingSphere=null;for(let r of t.intersectObject(i,!1))e&&e.distance<=r.distance||(e={body:this.members[n[r.instanceId]].body,distance:r.distance})}return e}};function Ov(s,t){return Math.hypot(s[0]-t.x,s[1]-t.y,s[2]-t.z)}var zr=class{constructor(t,e,i){this.run=t,this.group=new Ht;let n=new Map,r=(o,a,c)=>{let l=`${o.mesh} ${a}`;n.has(l)||n.set(l,{mesh:o.mesh,opacity:a,list:[]}),n.get(l).list.push({...c,...Bv(o,e[o.mesh].faces)})};t.bodies.forEach((o,a)=>{if(!(i.ghost&&!o.moves||o.opacity===0))for(let c of o.parts)r(c,o.opacity,{body:a,colour:null})});for(let{body:o,part:a}of i.ghost?[]:t.fixtures)o!==null&&t.bodies[o].opacity===0||r(a,1,{body:o,colour:i.fixture??Gi.fixture});this.sets=[...n.values()].map(({mesh:o,opacity:a,list:c})=>new Nh(c,e[o],i,a));for(let o of this.sets)this.group.add(...o.objects());this.showEdges(i.edges),this.applyTheme()}showEdges(t){for(let{lines:e}of this.sets)e&&(e.visible=t)}applyTheme(){for(let{lines:t}of this.sets)t?.material.color.setStyle(Be("edge"));this.paint(t=>this.plainColour(t))}plainColour(t){return this.run.bodies[t].colour??Be("fixed-body")}paint(t){let e=new Map;for(let{colours:i,members:n}of this.sets)n.forEach(({body:r,colour:o},a)=>{let c=o??t(r);e.has(c)||e.set(c,new At(c)),e.get(c).toArray(i,3*a)})}update(t,e){for(let i of this.sets)i.update(t.poses,e)}pick(t){return this.sets.map(i=>i.pick(t)).filter(Boolean).reduce((i,n)=>i&&i.distance<=n.distance?i:n,null)}};var Uv=7,kv=64,zv=3,Ic=class{constructor(t,e){if(this.radiusOf=e,this.group=new Ht,this.bodies=t.moving.filter(o=>t.bodies[o].opacity>0),this.bodies.length===0||this.bodies.length>kv)return;this.inks=this.bodies.map(o=>new At(t.bodies[o].colour).toArray());let i=()=>new ee(new Float32Array(3*this.bodies.length),3).setUsage(vi);this.geometry=new Kt,this.geometry.setAttribute("position",i()),this.geometry.setAttribute("color",i());let n=Uv*Math.min(2,devicePixelRatio),r=new kn(this.geometry,new xn({size:n,sizeAttenuation:!1,vertexColors:!0}));r.frustumCulled=!1,r.raycast=()=>{},this.group.add(r)}update(t,{place:e,pixels:i}){if(!this.geometry)return;let[n,r]=["position","color"].map(a=>this.geometry.getAttribute(a)),o=0;this.bodies.forEach((a,c)=>{let l=t.centreOf(a),h=Math.hypot(l[0]-e.x,l[1]-e.y,l[2]-e.z);this.radiusOf(a)*i<zv*h&&(n.setXYZ(o,...l),r.setXYZ(o,...this.inks[c]),o+=1)}),this.geometry.setDrawRange(0,o),n.needsUpdate=r.needsUpdate=!0}};var Gv=.25,Kn=[1.5,6],Vv=.33,Gr=24;function Yf(s){return Math.min(1,Math.max(0,1-(s-Kn[0])/(Kn[1]-Kn[0])))}function Hv(s,t){let e=Kn[1]*t,i=Math.ceil(e/s),n=[],r=[],o=(c,l)=>{n.push(c,l,0),r.push(1,1,1,.7*Yf(Math.hypot(c,l)/t))};for(let c=-i;c<=i;c+=1){let l=c*s;for(let h=-Gr;h<Gr;h+=1){let u=h/Gr*e,d=(h+1)/Gr*e;o(l,u),o(l,d),o(u,l),o(d,l)}}let a=new Kt;return a.setAttribute("position",new ee(new Float32Array(n),3)),a.setAttribute("color",new ee(new Float32Array(r),4)),a}function Wv(s){let t=new pr(0,Kn[1]*s,64,Gr),e=t.getAttribute("position"),i=new Float32Array(4*e.count).fill(1);for(let n=0;n<e.count;n+=1)i[4*n+3]=Yf(Math.hypot(e.getX(n),e.getY(n))/s);return t.setAttribute("color",new ee(i,4)),t}var Dc=class{constructor(t,e,i){let n=c=>[-1,1].map(l=>Array(3).fill(l*c/(Kn[1]*Math.sqrt(12)))),[r,o]=typeof e=="number"?n(e):e;this.group=new Ht,this.holders=[],this.size=Math.hypot(...o.map((c,l)=>c-r[l]))||1,this.middle=new D(...o.map((c,l)=>(c+r[l])/2)),this.cell=ac(Gv*this.size);let a={vertexColors:!0,transparent:!0,depthWrite:!1,side:He};this.ink=new ye(a),this.wash=new ci(a),this.shade=i?new gr({opacity:Vv,depthWrite:!1}):null,t.bodies.forEach((c,l)=>{if(c.half_spaces.length===0)return;let h=new Ht;if(c.opacity===0)return;let u=t.initial.subarray(7*l,7*l+7);for(let d of c.half_spaces)h.add(this.plane(d,u));this.holders.push({body:l,holder:h}),this.group.add(h)}),this.applyTheme()}plane({normal:t,offset_m:e},i){let n=new Ht,r=new D(...t).normalize();n.quaternion.copy(new Ne().setFromUnitVectors(new D(0,0,1),r)),n.position.copy(r).multiplyScalar(e);let o=new Ne(i[4],i[5],i[6],i[3]),a=this.middle.clone().sub(new D(i[0],i[1],i[2]));a.applyQuaternion(o.invert()).sub(n.position).applyQuaternion(n.quaternion.clone().invert());let c=u=>Math.round(u/this.cell)*this.cell,l=new D(c(a.x),c(a.y),0).applyQuaternion(n.quaternion);n.position.add(l);let h=[new Me(Wv(this.size),this.wash),new Ue(Hv(this.cell,this.size),this.ink)];if(this.shade){let u=new Me(new zn(Kn[1]*this.size,64),this.shade);u.receiveShadow=!0,h.push(u)}return h.forEach((u,d)=>{u.renderOrder=d-h.length}),n.add(...h),n}applyTheme(){this.ink.color.copy(new At(Be("grid"))),this.wash.color.copy(new At(Be("ground")))}update(t){for(let{body:e,holder:i}of this.holders){let n=t.poses.subarray(7*e,7*e+7);i.position.set(n[0],n[1],n[2]),i.quaternion.set(n[4],n[5],n[6],n[3])}}};var Xv=8,$f=16,Fh=8,jf=10,Zf=.1,Jf=.08,qv=Fh*jf+2,Kf=(s,t,e)=>s.map((i,n)=>i+(t[n]-i)*e);function Yv({kind:s,length_m:t},e,i,n){let r=Math.hypot(...e.map((u,d)=>i[d]-u));if(s==="rope"){let u=Math.min(Math.sqrt(.375*r*Math.max(0,t-r)),.5*t);return u>0?Array.from({length:$f+1},(d,f)=>{let g=f/$f;return Kf(e,i,g).map((x,p)=>x-n[p]*4*u*g*(1-g))}):[e,i]}if(s!=="spring")return[e,i];let o=r>0?e.map((u,d)=>(i[d]-u)/r):[0,0,1],[,a]=Bs(o),c=[o[1]*a[2]-o[2]*a[1],o[2]*a[0]-o[0]*a[2],o[0]*a[1]-o[1]*a[0]],l=Fh*jf,h=Array.from({length:l+1},(u,d)=>{let f=d/l,g=2*Math.PI*Fh*f,[x,p]=[Math.cos(g)*Jf*t,Math.sin(g)*Jf*t];return Kf(e,i,Zf+(1-2*Zf)*f).map((S,C)=>S+a[C]*x+c[C]*p)});return[e,...h,i]}var Lc=class{constructor(t,e=Gi,i=null){this.run=t,this.group=new Ht;let n=Math.hypot(...i??[0,0,0]);if(this.up=n>0?i.map(a=>-a/n):[0,0,1],t.links.length===0)return;let r=new vn(1,1,1,Xv).rotateX(Math.PI/2).translate(0,0,.5),o=new Gn({color:new At(e.fixture)});this.mesh=Jn(r,o,t.links.length*qv),this.mesh.castShadow=this.mesh.receiveShadow=!!e.shadows,this.mesh.raycast=()=>{},this.group.add(this.mesh)}update(t){if(!this.mesh)return;let e=new Float64Array(9),i=({body:r,point:o})=>r===null?o:(Xe(t,7*r+3,e),je(e,o).map((a,c)=>a+t[7*r+c])),n=0;for(let r of this.run.links){let o=Yv(r,...r.ends.map(i),this.up);for(let a=0;a+1<o.length;a+=1){let[c,l]=[o[a],o[a+1]],h=l.map((x,p)=>x-c[p]),u=Math.hypot(...h);if(!(u>0))continue;let[d,f]=Bs(h.map(x=>x/u)),g=x=>x.map(p=>p*r.radius_m);rn(this.mesh.instanceMatrix.array,n,g(d),g(f),h,c),n+=1}}this.mesh.count=n,this.mesh.instanceMatrix.needsUpdate=!0}};var Qf=22,$v=120,Zv=[["x",new D(1,0,0)],["y",new D(0,1,0)],["z",new D(0,0,1)]],Nc=class{constructor(t,e,i){this.colours=e,t.innerHTML='<svg viewBox="-34 -34 68 68" aria-hidden="true"></svg><div><span class="bar-length"></span><span class="bar-line"></span><span class="grid-cell" hidden></span></div>',this.axes=t.querySelector("svg"),this.bar=t.querySelector(".bar-line"),this.length=t.querySelector(".bar-length");let n=t.querySelector(".grid-cell");n.textContent=i===null?"":`grid ${vh(i)}`,n.hidden=i===null}draw(t,e){let i=ac($v/e);this.bar.style.width=`${i*e}px`;let n=vh(i);this.length.textContent!==n&&(this.length.textContent=n);let r=t.quaternion.clone().invert(),o=Zv.map(([l,h],u)=>({name:l,colour:this.colours[u],at:h.clone().applyQuaternion(r)}));o.sort((l,h)=>l.at.z-h.at.z);let c=o.map(({name:l,colour:h,at:u})=>{let[d,f]=[Qf*u.x,-Qf*u.y],g=Math.hypot(d,f),[x,p]=g>4?[d/g,f/g]:[.7,.7];return`<line x1="0" y1="0" x2="${d.toFixed(1)}" y2="${f.toFixed(1)}" stroke="${h}"/><text x="${(d+7*x).toFixed(1)}" y="${(f+7*p).toFixed(1)}" fill="${h}">${l}</text>`}).join("");this.text!==c&&(this.text=c,this.axes.innerHTML=c)}};var Bh=1024,Jv=/swiftshader|llvmpipe|softpipe|software|basic render/i;function tp(){let s=document.createElement("canvas").getContext("webgl2"),t=s?.getExtension("WEBGL_debug_renderer_info"),e=t?s.getParameter(t.UNMASKED_RENDERER_WEBGL):"";return s?.getExtension("WEBGL_lose_context")?.loseContext(),Jv.test(e)}function Kv(s,t){return s==="column"?[1,t]:[t,1]}var Fc=class{constructor(t,{shadows:e,antialias:i},n=Gi){this.canvas=t,this.shared=n;try{this.renderer=new Qa({canvas:t,antialias:i})}catch{throw new Zt("This browser draws no WebGL, so the bodies cannot be shown. The numbers can be saved.")}this.renderer.setPixelRatio(Math.min(2,devicePixelRatio)),this.renderer.shadowMap.enabled=e,this.renderer.shadowMap.type=Hn,this.scene=new ir,this.camera=new $e($n.radToDeg(n.field_of_view_rad),1,.1,1e3),this.camera.up.set(0,0,1);let{towards:r,lamp:o,ambient:a,sky:c}=n.light;this.towards=new D(...r).normalize();let l=h=>new At().setRGB(h,h,h,Un);this.sky=new yr(l(1),l((1-c)/(1+c)),Math.PI*a*(1+c)),this.sky.position.set(0,0,1),this.sun=new Mr(16777215,Math.PI*o),this.sun.castShadow=e,this.sun.shadow.mapSize.set(Bh,Bh),this.sun.shadow.radius=3,this.scene.add(this.sky,this.sun,this.sun.target),this.scene.background=new At,this.applyTheme()}applyTheme(){this.scene.background.setStyle(Be("stage"))}eye(){let t=this.canvas.clientHeight/2/Math.tan(this.shared.field_of_view_rad/2);return{place:this.camera.position,pixels:t}}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;return t===this.width&&e===this.height?!1:(this.width=t,this.height=e,this.renderer.setSize(t,e,!1),!0)}aimLight(t){let e=this.camera.position.distanceTo(t);this.camera.near=e/100,this.camera.far=e*40,this.sun.target.position.copy(t),this.sun.position.copy(t).addScaledVector(this.towards,2*e);let{camera:i,map:n}=this.sun.shadow,r=.75*e;Object.assign(i,{left:-r,right:r,bottom:-r,top:r,near:0,far:4*e}),i.updateProjectionMatrix(),this.sun.shadow.normalBias=3*r/(n?n.width:Bh)}draw(t,e,i){if(!(this.width>0&&this.height>0))return;this.aimLight(e);let[n,r]=Kv(i,t.length),[o,a]=[this.width/n,this.height/r];this.camera.aspect=o/a,this.camera.updateProjectionMatrix(),this.renderer.setScissorTest(t.length>1),t.forEach((c,l)=>{for(let d of t.flat())d.visible=c.includes(d);let[h,u]=r>1?[0,(r-1-l)*a]:[l*o,0];this.renderer.setViewport(h,u,o,a),this.renderer.setScissor(h,u,o,a),this.renderer.render(this.scene,this.camera)})}};var jv=500,ep=3,ip=5,Oh=class{constructor(t,e){this.bodies=new zr(t,e,{ghost:!0,shadows:!1,edges:!0}),this.group=this.bodies.group;for(let i of this.bodies.sets){for(let{mesh:n}of[i.fine,i.coarse].filter(Boolean)){let r=i.lines===null;Object.assign(n.material,{wireframe:r,transparent:!0,opacity:r?.3:.07,depthWrite:!1}),n.renderOrder=3}i.lines&&Object.assign(i.lines.material,{opacity:.95,depthTest:!1,transparent:!0}),i.lines&&(i.lines.renderOrder=4)}}paint(t){this.bodies.paint(()=>t);for(let{lines:e}of this.bodies.sets)e?.material.color.setStyle(t)}},Bc=class{constructor(t,e){this.canvas=t,this.tell=e;let i=tp();try{this.stage=new Fc(t,{shadows:!0,antialias:!i})}catch{throw new Zt("This browser draws no WebGL, so that the bodies cannot be shown. Turn on hardware acceleration, update the browser or take another one; or run the scene by the program: polhode view SCENE -o picture.png. The text stands beside.")}this.camera=new rc(this.stage,()=>this.dirty=!0),this.group=new Ht,this.stage.scene.add(this.group),this.dirty=!0,this.run=null,this.ghosts=new Map,this.hand=[],this.why=null,this.selected=null,this.listen()}show({runs:[t],meshes:e,look:i,gravity:n}){let o=this.run?.bodies.map(({name:h})=>h).join(`
`)===t.bodies.map(({name:h})=>h).join(`
`);this.run=t,this.geometries=e.map(qf),this.group.clear(),this.ghosts.clear();let a=t.bodies.length<=jv;this.poses=Float64Array.from(t.initial),this.snapshot={poses:this.poses,centreOf:h=>fc(t.bodies[h],this.poses,7*h)},this.radii=t.bodies.map(gh);let c=t.moving.filter(h=>t.bodies[h].box);this.size=cc(c.map(h=>this.radii[h]),.5)??gh({}),this.bodies=new zr(t,this.geometries,{shadows:a,edges:!0,ghost:!1}),this.ground=new Dc(t,ph(sc(t,t.initial)),a),this.joints=new Lc(t,{...i,shadows:a},n),this.dots=new Ic(t,h=>this.radii[h]),this.scale=new Nc(Et("scale"),i.axes,this.ground.holders.length>0?this.ground.cell:null),this.frame=Ns(yh(),new ye({color:yf,depthTest:!1,transparent:!0}),1),this.frame.renderOrder=5,this.pull=new Qe(Si,.05*this.size),this.forces=new Qe(Br,.045*this.size);let l=new Kt;l.setAttribute("position",new oe(new Float32Array(6),3)),this.line=new Ue(l,new ye({color:Or,depthTest:!1,transparent:!0})),this.line.frustumCulled=!1,this.line.renderOrder=8,this.group.add(this.ground.group,this.bodies.group,this.joints.group,this.dots.group,this.frame,this.pull.group,this.forces.group,this.line),this.selected!==null&&this.selected>=t.bodies.length&&(this.selected=null),this.why=null,this.hand=[],this.strongest=0,this.camera.home=t.frame,o||this.fit("home"),this.applyTheme()}setGhost(t,e){let i=this.ghosts.get(t);if(i&&this.group.remove(i.outline.group),this.ghosts.delete(t),this.dirty=!0,!e||!this.run)return;let n=new Oh(this.run,this.geometries);n.paint(e),this.ghosts.set(t,{outline:n,poses:Float64Array.from(this.run.initial),text:e}),this.group.add(n.group)}fit(t){this.stage.resize();let e=t==="home"?sc(this.run,this.run.initial):df(this.run,this.poses);this.camera.look(t,e,[1,1]),this.dirty=!0}applyTheme(){if(this.stage.applyTheme(),!!this.run){this.bodies.applyTheme(),this.ground.applyTheme();for(let{outline:t,text:e}of this.ghosts.values())t.paint(e);this.dirty=!0}}ray(t){let e=this.canvas.getBoundingClientRect(),i=new Rt(2*(t.clientX-e.left)/e.width-1,1-2*(t.clientY-e.top)/e.height),n=new Vn;return n.setFromCamera(i,this.stage.camera),n}listen(){let{canvas:t}=this,e=null;t.addEventListener("pointerdown",n=>{if(!this.run||n.button!==0)return;let r=this.ray(n),o=this.bodies.pick(r);e={x:n.clientX,y:n.clientY,hit:o,id:n.pointerId,plane:null},!(!o||!this.run.bodies[o.body].moves)&&(n.stopImmediatePropagation(),t.setPointerCapture(n.pointerId),e.point=r.ray.at(o.distance,new D))},{capture:!0}),t.addEventListener("pointermove",n=>{if(!e?.point||n.pointerId!==e.id)return;let r=Math.hypot(n.clientX-e.x,n.clientY-e.y)>ip;if(!e.plane&&r){let a=this.stage.camera.getWorldDirection(new D);e.plane=new Ye().setFromNormalAndCoplanarPoint(a,e.point),this.tell.grabbed(e.hit.body,e.point.toArray())}let o=e.plane&&this.ray(n).ray.intersectPlane(e.plane,new D);o&&this.tell.pulled(o.toArray())});let i=n=>{!e||n.pointerId!==e.id||(e.plane?this.tell.released():Math.hypot(n.clientX-e.x,n.clientY-e.y)<=ip&&this.tell.picked(e.hit?.body??null),e=null)};t.addEventListener("pointerup",i),t.addEventListener("pointercancel",i),t.addEventListener("webglcontextrestored",()=>this.dirty=!0)}select(t){this.selected=t,this.dirty=!0}setHand(t){this.hand=t,this.dirty=!0}setForces(t){this.why=t,this.dirty=!0}draw(){if(this.stage.resize()&&(this.dirty=!0),!this.dirty||!this.run)return;this.dirty=!1,this.bodies.update(this.snapshot,this.stage.eye()),this.joints.update(this.poses),this.dots.update(this.snapshot,this.stage.eye()),this.ground.update(this.snapshot);for(let{outline:i,poses:n}of this.ghosts.values())i.bodies.update({poses:n},this.stage.eye());let t=this.run.bodies[this.selected]?.box;this.frame.visible=!!t,t&&(xh(this.frame.instanceMatrix.array,0,t,this.poses,this.selected),this.frame.instanceMatrix.needsUpdate=!0),this.drawHand(),this.drawForces(),this.stage.draw([[this.group]],this.camera.target,"row");let e=this.stage.camera.position.distanceTo(this.camera.target);this.scale.draw(this.stage.camera,this.stage.eye().pixels/e)}drawHand(){let{hand:t}=this;if(this.line.visible=t.length>0,this.pull.clear(),t.length>0){let e=this.line.geometry.getAttribute("position");e.setXYZ(0,t[0],t[1],t[2]),e.setXYZ(1,t[3],t[4],t[5]),e.needsUpdate=!0;let i=t.slice(6),n=Math.hypot(...i);this.strongest=Math.max(this.strongest,n),this.pull.add(t.slice(3,6),i,ep*this.size/this.strongest)}this.pull.show()}drawForces(){this.forces.clear();let t=this.why??[],e=Math.max(0,...t.map(({force:i})=>Math.hypot(...i)));for(let{point:i,force:n}of t){let r=ep*this.size/e,o=i.map((a,c)=>a-n[c]*r);this.forces.add(t[0].point===i?i:o,n,r)}this.forces.show()}};var np="polhode-playground-text";function sp(s,t){try{localStorage.setItem(np,JSON.stringify({page:s,text:t}))}catch{}}function rp(s){try{let t=JSON.parse(localStorage.getItem(np));return t?.page===s&&typeof t.text=="string"?t.text:null}catch{return null}}var Qv="http://www.w3.org/2000/svg",ap=1e-9,Uh=4;function ln(s,t,...e){let i=document.createElementNS(Qv,s);for(let[n,r]of Object.entries(t))i.setAttribute(n,r);return i.append(...e),i}var Us=(s,t)=>s[0]*t[0]+s[1]*t[1]+s[2]*t[2],hi=s=>Math.hypot(...s);function tS(s,t){let e=null;for(let c of s){let l=Us(c,t),h=c.map((u,d)=>u-l*t[d]);(!e||hi(h)>hi(e))&&(e=h)}let i=e?hi(e):0,n=Math.max(...s.map(hi),0);if(i>1e-6*n)return e.map(c=>c/i);let r=Math.abs(t[0])<.9?[1,0,0]:[0,1,0],o=Us(r,t),a=r.map((c,l)=>c-o*t[l]);return a.map(c=>c/hi(a))}function kh(s,t,e){let[i,n]=[t[0]-s[0],t[1]-s[1]],r=Math.hypot(i,n),o=Math.min(8,r/2),[a,c]=r>0?[i/r,n/r]:[0,0],l=[t[0]-a*o,t[1]-c*o],h=o*.4;return ln("g",{class:e},ln("line",{x1:s[0],y1:s[1],x2:l[0],y2:l[1]}),ln("path",{d:`M${t[0]} ${t[1]}L${l[0]-c*h} ${l[1]+a*h}L${l[0]+c*h} ${l[1]-a*h}Z`}))}function eS(s,t,e,i){let n=[[0,0]];for(let{force:p}of s){let[m,S]=n.at(-1);n.push([m+Us(p,e),S+Us(p,i)])}let r=[Us(t,e),Us(t,i)],o=[...n,r],[a,c]=[0,1].map(p=>p).reduce((p,m)=>(p[0][m]=Math.min(...o.map(S=>S[m])),p[1][m]=Math.max(...o.map(S=>S[m])),p),[[],[]]),l=Math.max(c[0]-a[0],c[1]-a[1],1e-300),[h,u,d]=[300,150,26],f=Math.min((h-2*d)/l,(u-2*d)/l),g=([p,m])=>[h/2+(p-(a[0]+c[0])/2)*f,u/2-(m-(a[1]+c[1])/2)*f],x=ln("svg",{viewBox:`0 0 ${h} ${u}`,role:"img","aria-label":"Force polygon"});return s.forEach(({from:p,kind:m},S)=>{let C=3*(S-s.length/2),[b,A]=[g(n[S]),g(n[S+1])].map(([M,F])=>[M+C,F]),E=kh(b,A,m);E.prepend(ln("title",{},p)),x.append(E);let _=ln("text",{x:(b[0]+A[0])/2+6,y:(b[1]+A[1])/2+(S%2===0?-2:10),class:m});_.textContent=p,x.append(_)}),hi(t)*f>4&&x.append(kh(g([0,0]),g(r),"total")),x}function iS({from:s,cone:t}){let[e,i,n]=[92,92,84],r=ln("svg",{viewBox:`0 0 ${e} ${i}`,role:"img",class:"cone"});r.setAttribute("aria-label",`Friction cone of the contact with ${s}`);let o=66,c=Math.min(t.coefficient,1.1)*o;r.append(ln("path",{class:"cone-area",d:`M46 ${n}L${46-c*.6} ${n-o}L${46+c*.6} ${n-o}Z`})),r.append(ln("line",{class:"axis",x1:46,y1:n,x2:46,y2:n-o}));let l=Math.min(t.needed??0,1.2),h=t.coefficient>0&&l>=t.coefficient*(1-1e-6);return r.append(kh([46,n],[46+l*o*.6,n-o*.96],h?"reaction used":"reaction")),r}var Oc=class{constructor(t){this.root=t,this.body=t.querySelector(".why-body"),this.title=t.querySelector("h2 span")}clear(){this.root.hidden=!0,this.body.replaceChildren()}refuse(t,e){this.root.hidden=!1,this.title.textContent=t;let i=document.createElement("p");i.textContent=e,this.body.replaceChildren(i)}show(t,e){this.root.hidden=!1,this.title.textContent=t.name;let i=hi(e??[0,0,0]),n=i>0?e.map(u=>-u/i):[0,0,1],r=Math.max(...t.forces.map(({force:u})=>hi(u)),hi(t.others),0),o=nS(t,r),a=tS(o.map(({force:u})=>u),n),c=document.createElement("p"),l=hi(t.mass_times_acceleration);c.textContent=l<=1e-6*r?"The forces close the polygon: the body is in equilibrium.":`The forces add up to m a = ${ae(l,"N")}.`,this.body.replaceChildren(eS(o,t.mass_times_acceleration,a,n),c);let h=t.forces.filter(({cone:u,force:d})=>u&&hi(d)>ap*r);h.sort((u,d)=>(d.cone.needed??0)-(u.cone.needed??0));for(let u of h.slice(0,Uh)){let d=document.createElement("div");d.className="contact";let f=document.createElement("p");f.textContent=`${u.words}.`,d.append(iS(u),f),this.body.append(d)}if(h.length>Uh){let u=document.createElement("p");u.textContent=`${h.length-Uh} more contacts use less of their friction.`,this.body.append(u)}if(h.length===0&&t.forces.length===1){let u=document.createElement("p");u.textContent="Nothing touches it: it flies freely.",this.body.append(u)}return this.margins=document.createElement("p"),this.margins.className="margins",this.margins.textContent=h.length>0?"Looking for what would have to change …":"",this.body.append(this.margins),h.length>0}showMargins(t){this.margins.textContent=sS(t)}};function nS(s,t){let e=[];for(let{from:i,force:n,cone:r}of s.forces){if(hi(n)<=ap*t)continue;let o=r&&e.find(a=>a.from===i&&a.kind==="contact");o?o.force=o.force.map((a,c)=>a+n[c]):e.push({from:i,force:[...n],kind:r?"contact":i==="its weight"?"weight":"other"})}return hi(s.others)>1e-6*t&&e.push({from:"the rest: fields of the scene",force:s.others,kind:"other"}),e}function op(s){if(!s||s.length===0)return"nothing begins to move";let[t]=s,e=s.length>1?` with ${s.length-1} more`:"";return`${t.body} ${t.how}${e}`}function sS(s){if(s.bodies===0)return"No body that touches another is at rest: what would have to change is asked of bodies at rest.";let t=s.friction_needed,e=[];t===null?e.push("Friction alone does not hold the bodies at rest."):t===0?e.push("No friction is needed: they stand without any."):e.push(`All at rest stand until friction falls to ${Rn(t)} of what it is; then ${op(s.begins)}.`);let n=s.pushes.filter(({of_weight:r})=>typeof r=="number").reduce((r,o)=>r&&r.of_weight<=o.of_weight?r:o,null);if(n){let r=n.tilt_rad===null?"":`, or a tilt of ${ae(n.tilt_rad*180/Math.PI)}°,`;e.push(`A push of ${Rn(n.of_weight)} of each weight${r} is the least that moves one: ${op(n.begins)}.`)}else s.pushes.length>0&&e.push("No push across gravity moves any.");return e.join(" ")}var rS=.1,oS=.03,aS=.25,cS=250,lS=1e-12,zh="#12a150",cp="#c2379d",hS=`format = 1
name = "first"
duration = 5.0

[materials.wood]
friction = 0.4
restitution = 0.3

[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "wood"

[[bodies]]
name = "box"
shape.box.size = [0.4, 0.3, 0.2]
mass = 1.0
position = [0, 0, 0.6]
rotation_vector = [0.4, 0.3, 0]
material = "wood"
`,Uc=class{constructor(t,e){this.given=t,this.source=e,this.time=0,this.speed=1,this.playing=!1,this.beyond=!1,this.engine=null,this.copies=new Map,this.hand=null,this.told=null,this.asked_at=0,this.count=0,this.editor=new Ac(Et("editor"),{typed:()=>this.keep(),changed:()=>this.edited()}),this.lights=new Pc(Et("panel")),this.energies=new Tc(Et("energies")),this.distances=new Ec(Et("distances")),this.why=new Oc(Et("why")),Et("title").textContent=t.title||"polhode playground",this.controls=zf(this),kf(Et("help").querySelector("table")),Gf(this),Bf(this)}published(){return{ready:new Promise(t=>this.whenReady=t),time:()=>this.time,seek:t=>this.seek(t),play:()=>this.play(),pause:()=>this.pause(),load:t=>this.take(t),hash:()=>this.engine.ask({do:"ask",name:"hash"}).then(({answer:t})=>t),track:()=>this.engine.track,copy:t=>this.copies.get(t)?.track??null,pick:t=>this.pick(t),toEnd:()=>this.toEnd(),self:this}}async firstText(){let t=null;try{let n=await Ih(location.hash);if(n!==null)return{text:n,words:t}}catch(n){t=on(n)}let e=this.given.text??null,i=rp(e);return i!==null&&i!==e&&e!==null&&!t&&(t="The text that you typed in this page before is here again.",this.anew=e),{text:i??e??hS,words:t}}keep(){sp(this.given.text??null,this.editor.text)}async start(t){let{text:e,words:i}=await this.firstText();this.editor.text=e,i&&this.notice(i),this.anew&&this.offerAnew(),this.picture=new Bc(Et("stage"),{picked:n=>this.pick(n),grabbed:(n,r)=>this.grab(n,r),pulled:n=>this.pull(n),released:()=>this.release()}),gf(Et("theme"),()=>this.applyTheme()),this.module=await t(),this.engine=this.newEngine(),await this.engine.started;for(let[n,r]of Object.entries(this.given.files??{}))await this.addFile(n,Uint8Array.from(atob(r),o=>o.charCodeAt(0)));addEventListener("hashchange",()=>this.followAddress()),await this.run(),requestAnimationFrame(n=>this.tick(n)),this.playing=!matchMedia("(prefers-reduced-motion: reduce)").matches,this.whenReady()}offerAnew(){let t=document.createElement("button");t.textContent="Begin with the scene of the page",t.addEventListener("click",()=>{t.parentElement.remove(),this.take(this.anew)}),Et("notices").lastElementChild.append(" ",t)}newEngine(){return new Rc(this.source,this.module,{mark:t=>this.lights.mark(t),broke:(t,e)=>this.broke(t,e)})}async followAddress(){if(this.own_hash!==location.hash)try{let t=await Ih(location.hash);t!==null&&this.take(t)}catch(t){this.notice(on(t))}}notice(t){this.count+=1;let e=document.createElement("p");e.className="mild",e.textContent=t;let i=document.createElement("button");i.textContent="Close",i.addEventListener("click",()=>e.remove()),e.append(" ",i);let n=Et("notices");[...n.children].some(r=>r.firstChild.textContent===t)||n.replaceChildren(...[...n.children].slice(-2),e)}take(t){return this.editor.text=t,this.keep(),this.run({edited:!0})}edited(){return this.run({edited:!0})}changes(t=Et("tier").value){let e=Et("law").value;return[...t?[`method.tier="${t}"`]:[],...e?[`method.impact="${e}"`]:[]]}native(){let{native:t,text:e}=this.given;return t&&e===this.editor.text&&this.changes().length===0?t:null}async run({edited:t=!1}={}){if(!this.engine)return;let e=this.editor.text,i=this.runs=(this.runs??0)+1;this.loading&&await this.unlessStuck();let n=this.native();try{this.loading=this.engine.load(e,this.changes(),{marks:n?.marks??[]});let{show:r,surface:o}=await this.loading;if(i!==this.runs)return;this.showScene(r,o,n),t&&(this.playing=!0,this.putIntoAddress(e)),await this.runCopies(e,i)}catch(r){i===this.runs&&this.refuse(r)}finally{this.loading=null}}async unlessStuck(){let t=new Promise(i=>setTimeout(i,1500,"stuck"));await Promise.race([this.loading.catch(()=>null),t])==="stuck"&&this.engine.restart()}showScene(t,e,i){this.editor.accept();let n=Af(t);this.scene=n,document.title=n.title,Et("title").textContent=n.title,Et("description").textContent=n.description,Et("description").hidden=n.description==="",this.time=0,this.beyond=!1,this.hand=null,this.told=null,this.lights.begin(i),this.energies.clear(),this.distances.clear(),this.why.clear(),this.picture.show(n),this.controls.showSurface(e),this.controls.showSpeed(this.firstSpeed(n.runs[0].duration))}firstSpeed(t){return this.shown_duration===t?this.speed:(this.shown_duration=t,this.speed=t<1?Pn.findLast(e=>e<=t/2)??Pn[0]:1,this.speed)}refuse(t){t instanceof cn&&!t.grave?this.editor.refuse(t.message,t.places):this.notice(`${t instanceof cn?t.message:on(t)} Your text is kept.`)}broke(t,e){e===this.engine&&(this.pause(),this.notice(`The run ended: ${t.message}. Change the scene, or go back and act in another way; your text is kept.`),t.grave&&e.restart())}async putIntoAddress(t){try{this.own_hash=await Cf(t),history.replaceState(null,"",this.own_hash)}catch{this.own_hash=null}}async setCopy(t,e){if(Et(t).setAttribute("aria-pressed",String(e)),this.copies.get(t)?.end(),this.copies.delete(t),this.distances.drop(t),this.picture.setGhost(t,null),!!e){if(t==="truth"&&Et("tier").value===""){Et("tier").value="fast",this.copies.set(t,this.newEngine()),this.distances.begin(t,"Truth",zh),await this.run();return}this.copies.set(t,this.newEngine()),this.distances.begin(t,t==="truth"?"Truth":"Second copy",t==="truth"?zh:cp),await this.run()}}async runCopies(t,e){for(let[i,n]of this.copies){let r=i==="truth"?this.changes("accurate"):this.changes();try{for(let[a,c]of this.engine.files)n.files.has(a)||await n.addFile(a,c);let{shifted:o}=await n.load(t,r,{shift:i==="twin"?lS:0});if(e!==this.runs)return;if(i==="twin"&&o===null)throw new Zt("no body of this scene can be moved by itself");this.picture.setGhost(i,i==="truth"?zh:cp)}catch(o){if(e!==this.runs)return;this.notice(`${i==="truth"?"The accurate method":"A second copy"} refuses this scene: ${o.message}`),this.setCopy(i,!1)}}}tracks(){return[this.engine?.track,...[...this.copies.values()].map(t=>t.track)].filter(Boolean)}play(){let{track:t}=this.engine;t?.ended&&this.time>=t.end&&!this.beyond&&(this.time=t.first),this.playing=!0}pause(){this.playing=!1}toggle(){this.playing?this.pause():this.play()}seek(t){let{track:e}=this.engine;this.time=Math.min(e.end,Math.max(e.first,t)),this.show()}restart(){this.run(),this.playing=!0}async toEnd(){this.pause();let{track:t}=this.engine;for(;!t.ended&&!t.done;)this.engine.goTo(t.duration,!1),await new Promise(e=>setTimeout(e,5));return this.time=t.end,(await this.engine.ask({do:"ask",name:"hash"})).answer}tick(t){requestAnimationFrame(n=>this.tick(n));let e=Math.min(aS,(t-(this.before??t))/1e3);this.before=t;let{track:i}=this.engine;i&&this.playing&&this.advance(i,e),i&&this.show(),this.engine.isStuck()?this.stuck():this.told_stuck&&this.goesOn(),t-this.asked_at>cS&&i&&!this.asking&&this.askReport(t)}advance(t,e){let i=this.time+e*this.speed,n=this.hand?oS:rS;for(let a of[this.engine,...this.copies.values()])a.goTo(i+n*this.speed,this.beyond);let r=Math.min(...this.tracks().map(a=>a.end));i>this.time&&(this.time=Math.max(this.time,Math.min(i,r))),(t.ended&&!this.beyond&&this.time>=t.end||t.done&&this.time>=t.end)&&this.pause()}stuck(){if(this.told_stuck)return;this.told_stuck=!0,this.notice("The engine has been in one step for seconds: this scene may never end. “Stop” ends it and keeps your text; a larger step or another method may help.");let e=document.createElement("button");e.id="stop",e.textContent="Stop",e.addEventListener("click",()=>this.stop()),Et("notices").lastElementChild.append(e)}goesOn(){Et("stop")?.parentElement.remove(),this.told_stuck=!1}stop(){this.pause(),this.engine.restart();for(let t of this.copies.values())t.restart();Et("notices").replaceChildren(),this.told_stuck=!1,this.editor.refuse("Stopped. Change the scene, and it runs again.",[])}show(){let{picture:t,engine:e}=this,{track:i}=e;if(!(!t.run||i.times.length===0||i.width!==t.poses.length)){if(this.time!==this.shown_time||i.end!==this.shown_end){i.at(this.time,t.poses);for(let[n,r]of this.copies){let o=t.ghosts.get(n);o&&r.track?.width===o.poses.length&&r.track.at(this.time,o.poses)}t.dirty=!0,this.shown_time=this.time,this.shown_end=i.end}this.hand&&i.held.length>0?t.setHand([...this.hand,...i.held.slice(3)]):t.hand.length>0&&t.setHand([]),Et("pull").hidden=t.hand.length===0,t.hand.length>0&&(Et("pull").textContent=`You pull with ${ae(Math.hypot(...t.hand.slice(6)),"N")}`),this.measure(i),this.distances.draw(this.time,t.size),this.controls.showTime(this,i),t.draw()}}measure(t){for(let[e,i]of this.copies){if(i.track?.width!==t.width||i.track.times.length===0)continue;let n=Math.min(this.time,i.track.end,t.end),r=t.duration/400;if(n-Math.max(0,this.distances.lastTime(e))<r&&this.distances.lastTime(e)>=0)continue;let o=this.picture.run.moving;this.distances.add(e,n,t.distance(i.track,n,o))}}async askReport(t){this.asked_at=t,this.asking=!0;let{engine:e}=this,i=this.runs;try{if(e.track.steps>0){let{answer:n}=await e.ask({do:"ask",name:"told"});i===this.runs&&(this.told=JSON.parse(n),this.energies.show(this.told),this.lights.show(this.told,this.time),this.controls.showPace(e.track))}}catch{}this.asking=!1}async act(t,e){this.beyond=!0,this.distances.cut(this.time);let i=[this.engine,...this.copies.values()].map(n=>n.act(t,e,this.time));try{let[{surface:n}]=await Promise.all(i);this.controls.showSurface(n)}catch(n){this.notice(`${n.message}.`)}}grab(t,e){return this.hand=e,this.playing=!0,this.select(t),this.act("grab",[t,...e])}pull(t){if(this.hand){this.hand=t;for(let e of[this.engine,...this.copies.values()])e.send({do:"pull",args:t})}}release(){this.hand=null;for(let t of[this.engine,...this.copies.values()])t.ask({do:"ask",name:"release"}).catch(()=>{})}push(){let{picture:t}=this,e=t.selected;if(e===null||!t.run.bodies[e].moves)return;let i=t.stage.camera.getWorldDirection(t.camera.target.clone()).toArray(),n=this.scene.gravity??[0,0,-9.81],r=Math.hypot(...n),o=r>0?i.reduce((h,u,d)=>h+u*n[d]/r,0):0,a=i.map((h,u)=>h-(r>0?o*n[u]/r:0)),c=Math.sqrt((r||9.81)*t.radii[e])/(Math.hypot(...a)||1),l=7*e;this.playing=!0,this.act("push",[e,[...t.poses.slice(l,l+3)],a.map(h=>h*c)])}setFriction(t){return this.act("set_friction",[t])}setRestitution(t){return this.act("set_restitution",[t])}select(t){this.picture.select(t),t===null&&(this.why.clear(),this.picture.setForces(null))}async pick(t){if(this.select(t),t===null)return;this.pause();let e=this.picture.run,{name:i}=e.bodies[t],{engine:n}=this;if(!e.bodies[t].moves){this.why.refuse(i,"It is fixed, or moves as prescribed: forces do not move it. Click a body that moves."),this.picture.setForces(null);return}try{let{answer:r}=await n.ask({do:"ask",name:"why",args:[t],at:this.time}),o=JSON.parse(r);if(this.picture.selected!==t)return;let a=this.why.show(o,this.scene.gravity);if(this.picture.setForces(o.forces.map(({point:l,force:h})=>({point:l,force:h}))),!a)return;let{answer:c}=await n.ask({do:"ask",name:"margins",at:this.time});this.picture.selected===t&&this.why.showMargins(JSON.parse(c))}catch(r){this.why.refuse(i,r.message)}}applyTheme(){this.picture.applyTheme(),this.picture.dirty=!0}async addFile(t,e){for(let i of[this.engine,...this.copies.values()])await i.addFile(t,e)}async sceneOf(t){return(await this.engine.ask({do:"ask",name:"scene_of",args:[t]})).answer}saveText(){Of(this.editor.text,`${this.scene?.runs[0].name??"scene"}.toml`)}async link(){await this.putIntoAddress(this.editor.text);let{href:t}=location;try{await navigator.clipboard.writeText(t),this.notice(`The link is copied: ${ae(t.length)} letters. Whoever opens it, sees this scene.`)}catch{this.notice("The address of this page is now the scene: copy it from the address bar.")}}};async function uS(){if(typeof WebAssembly!="object")throw new Zt("This browser has no WebAssembly, so that the scene cannot run here. Turn it on (it is off in the lockdown mode of some systems), open the page in another browser, or run the scene by the program: polhode run SCENE.");let s=Rh("polhode-engine","its engine"),t;try{t=eu(s)}catch{throw new Zt("The engine cannot be unpacked: the page is damaged or was cut off.")}try{return await WebAssembly.compile(t)}catch(e){throw new Zt(`This browser refuses the engine (${e?.message??e}). A policy of the page or of the system forbids WebAssembly: open the file itself, use another browser, or run the scene by the program: polhode run SCENE.`)}}function dS(){try{return JSON.parse(Ef("polhode-play")??"null")??{}}catch{return{}}}async function fS(){let s=dS();s.examples=JSON.parse(await kr("polhode-examples","The scenes"));let t=new Uc(s,await kr("polhode-worker","The worker"));window.polhode=t.published();try{await t.start(uS),document.body.classList.add("ready")}catch(e){Et("message").textContent=on(e),Et("message").hidden=!1,document.body.classList.add("failed"),window.polhode.failed=on(e)}}fS();})();
